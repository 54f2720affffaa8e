//! Programs that are timed: a lab's binary, one of its variants, and the variant's settings.

use std::fmt;
use std::str::FromStr;

use anyhow::Result;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::facts::{Discs, Facts, Work, Workers};
use crate::kit::Kit;
use crate::lab::Lab;

/// A variant of a lab's program, the student's or the solution's, in the notation of the command
/// line.
///
/// Examples are `lab3`, `lab3:fork-join` and `solution3:fork-join,t=2,padding=1`. A lab may have
/// additional programs, which its facts name: `lab9-hard:basic-f32`. The facts are read from the
/// kit around the current folder.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Number of the lab.
    pub lab: Lab,
    /// Whether the program is the solution's, not the student's.
    pub solution: bool,
    /// Name of one of the lab's other programs; `None` for the first program.
    ///
    /// The name follows the lab's own name, as `hard` does in `lab9-hard`.
    other: Option<String>,
    /// Kind of discs that the program simulates.
    pub discs: Discs,
    /// Workers that share the program's work.
    pub workers: Workers,
    /// Name of the variant; `None` for the lab's first variant.
    pub variant: Option<String>,
    /// Threads of the process, or of each rank; `None` if the command decides.
    pub threads: Option<usize>,
    /// Number of processes, for labs with ranks; `None` if the command decides.
    pub ranks: Option<usize>,
    /// Parameters of the variant, as for `--param`.
    pub parameters: Vec<(String, f64)>,
}

impl Program {
    /// Returns a lab's first variant, with default settings.
    ///
    /// # Errors
    /// If the current folder is not in a kit with this lab.
    pub fn new(lab: Lab, solution: bool) -> Result<Self> {
        let Facts { discs, workers, .. } = Kit::find()?.facts(lab)?;
        Ok(Self { lab, solution, discs, workers, ..Self::default() })
    }

    /// Returns the solutions that simulate these discs with these workers, in order.
    pub fn solutions(kit: &Kit, discs: Discs, workers: Workers) -> Result<Vec<Self>> {
        let programs = kit.solutions().into_iter().map(|lab| Self::new(lab, true));
        let mut programs = programs.collect::<Result<Vec<_>>>()?;
        programs.retain(|program| (program.discs, program.workers) == (discs, workers));
        Ok(programs)
    }

    /// Returns the program with a different variant.
    pub fn with_variant(mut self, variant: &str) -> Self {
        self.variant = Some(variant.into());
        self
    }

    /// Returns the lab's other programs that simulate something. Programs that time single loops
    /// are left out.
    pub fn others(&self) -> Result<Vec<Self>> {
        let mut others = Vec::new();
        for (name, work) in Kit::find()?.facts(self.lab)?.programs {
            if work != Work::Loops {
                others.push(self.other(name, work));
            }
        }
        Ok(others)
    }

    /// Makes the lab's other program of this name.
    fn other(&self, name: String, work: Work) -> Self {
        let discs = if work == Work::Hard { Discs::Hard } else { Discs::Soft };
        Self { other: Some(name), discs, ..self.clone() }
    }

    /// Returns the value of a parameter; `None` if it is not set.
    pub fn parameter(&self, name: &str) -> Option<f64> {
        let set = self.parameters.iter().find(|(known, _)| known == name);
        set.map(|(_, value)| *value)
    }

    /// Returns the name of the program's binary.
    pub fn binary(&self) -> String {
        let other = self.other.as_ref().map(|other| format!("-{other}"));
        self.package() + &other.unwrap_or_default()
    }

    /// Returns the name of the program's Cargo package.
    pub fn package(&self) -> String {
        format!("{}{}", if self.solution { "solution" } else { "lab" }, self.lab)
    }

    /// Whether the program's workers are processes that exchange messages.
    pub fn has_ranks(&self) -> bool {
        self.workers == Workers::Ranks
    }

    /// Whether the program simulates hard discs.
    pub fn is_hard(&self) -> bool {
        self.discs == Discs::Hard
    }
}

impl FromStr for Program {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split(',');
        let name = parts.next().unwrap_or_default();
        let (package, variant) = divided(name, ':');
        let (package, other) = divided(package, '-');
        let (solution, lab) = match package.strip_prefix("solution") {
            Some(number) => (true, number.parse()?),
            None => (false, package.parse()?),
        };
        let mut program = Self::new(lab, solution).map_err(|e| format!("{e:#}"))?;
        if let Some(other) = other {
            let facts = Kit::find().and_then(|kit| kit.facts(lab)).map_err(|e| format!("{e:#}"))?;
            let work = facts.programs.get(other);
            let work = work.ok_or_else(|| format!("there is no {package}-{other}"))?;
            program = program.other(other.into(), *work);
        }
        program.variant = variant.map(Into::into);
        for part in parts {
            let (name, value) = part
                .split_once('=')
                .ok_or_else(|| format!("'{part}' in '{text}' is not NAME=VALUE"))?;
            match name {
                "t" | "threads" => program.threads = Some(count(value, "threads")?),
                "r" | "ranks" => program.ranks = Some(count(value, "ranks")?),
                _ => {
                    let value = value.parse().map_err(|_| format!("'{value}' is not a number"))?;
                    program.parameters.push((name.into(), value));
                }
            }
        }
        Ok(program)
    }
}

/// Divides a text at the first `sign`; the second part is `None` if there is no such sign.
fn divided(text: &str, sign: char) -> (&str, Option<&str>) {
    text.split_once(sign).map_or((text, None), |(first, second)| (first, Some(second)))
}

/// Parses a number of threads or ranks, at least 1.
fn count(value: &str, what: &str) -> Result<usize, String> {
    let number = value.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| format!("'{value}' is not a number of {what}"))
}

impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.binary())?;
        if let Some(variant) = &self.variant {
            write!(f, ":{variant}")?;
        }
        if let Some(ranks) = self.ranks {
            write!(f, ",r={ranks}")?;
        }
        if let Some(threads) = self.threads {
            write!(f, ",t={threads}")?;
        }
        for (name, value) in &self.parameters {
            write!(f, ",{name}={value}")?;
        }
        Ok(())
    }
}

/// Writes the program in the notation of the command line.
impl Serialize for Program {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Program {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_are_written_as_they_are_read() {
        for text in [
            "lab2",
            "solution2:sorted",
            "solution3:fork-join,t=2",
            "lab4:region-locks,t=8,regions=20,x=0.5",
            "solution6:halo,r=4,t=2",
            "solution9-hard:basic-f32,workgroup=64",
        ] {
            assert_eq!(text.parse::<Program>().unwrap().to_string(), text);
        }
        for text in [
            "",
            "lab",
            "lab0:x",
            "solution:x",
            "lab2:x,t",
            "lab2:x,t=0",
            "lab2:x,k=y",
            "lab2-hard:x",
        ] {
            assert!(text.parse::<Program>().is_err(), "{text}");
        }
    }
}
