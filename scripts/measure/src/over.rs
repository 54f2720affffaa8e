//! The quantity that an experiment varies, and its values.

use std::fmt;
use std::str::FromStr;

use anyhow::{Result, bail, ensure};

use crate::job::Job;
use crate::scene::Scene;
use lab_kit::machine::{cores, doubled_up_to};
use lab_kit::program::Program;

/// A quantity that can vary: an option of the labs' programs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Varied {
    /// Number of particles or discs.
    N,
    /// Side L of the square of hard discs.
    Length,
    /// Radius r of hard discs.
    Radius,
    /// Mean number of soft discs in the area of a cutoff disc.
    Neighbours,
    /// Number of threads of the process, or of each rank.
    Threads,
    /// Number of ranks of a lab with messages.
    Ranks,
    /// Value of a parameter of the variants, as for `--param`.
    Parameter(String),
}

/// The quantity with its values: `n=5000,10000`, or `radius` alone for the values of the CS3210
/// report.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Over {
    pub(crate) varied: Varied,
    values: Vec<f64>,
}

impl FromStr for Over {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, list) = text.split_once('=').unwrap_or((text, ""));
        let varied = match name.trim() {
            "" => return Err("expected WHAT=VALUES, such as n=1000,10000".into()),
            "n" => Varied::N,
            "length" | "L" => Varied::Length,
            "radius" => Varied::Radius,
            "neighbours" => Varied::Neighbours,
            "t" | "threads" => Varied::Threads,
            "r" | "ranks" => Varied::Ranks,
            parameter => Varied::Parameter(parameter.into()),
        };
        let listed = list.split(',').filter(|_| text.contains('='));
        let values = listed.map(|value| varied.value(value.trim())).collect::<Result<_, _>>()?;
        Ok(Self { varied, values })
    }
}

impl Over {
    /// Returns the user's values, or values that fit the lab's problem.
    pub(crate) fn values(&self, lab: &Program) -> Result<Vec<f64>> {
        let hard = lab.is_hard();
        match self.varied {
            Varied::Length | Varied::Radius => {
                ensure!(hard, "lab {}'s discs are soft: it has no {}", lab.lab, self.varied);
            }
            Varied::Neighbours => {
                ensure!(!hard, "lab {}'s discs are hard: they have no {}", lab.lab, self.varied);
            }
            Varied::Ranks => ensure!(lab.has_ranks(), "lab {} has no ranks", lab.lab),
            Varied::N | Varied::Threads | Varied::Parameter(_) => {}
        }
        if !self.values.is_empty() {
            return Ok(self.values.clone());
        }
        Ok(match self.varied {
            Varied::N if hard => vec![5e3, 1e4, 2e4, 3e4, 4e4, 5e4],
            Varied::Length => vec![5e3, 1e4, 2e4, 1e5, 1e6, 1e7],
            Varied::Radius => vec![1.0, 4.0, 64.0, 128.0, 256.0, 512.0, 1024.0],
            Varied::Neighbours => vec![0.02, 0.06, 0.16, 0.3, 0.6, 1.2, 4.7],
            Varied::Threads | Varied::Ranks => {
                doubled_up_to(2 * cores()).into_iter().map(|p| p as f64).collect()
            }
            _ if self.varied.is_workgroup() => vec![8.0, 32.0, 64.0, 256.0, 1024.0, 2048.0],
            Varied::N | Varied::Parameter(_) => {
                bail!("over which values? Such as --over {}=1000,10000", self.varied)
            }
        })
    }
}

impl Varied {
    pub(crate) fn jobs(&self, values: &[f64], programs: &[Program], like: &Job) -> Vec<Job> {
        let mut jobs = Vec::new();
        for &value in values {
            for program in programs {
                jobs.push(self.set(Job { program: program.clone(), ..like.clone() }, value));
            }
        }
        jobs
    }

    fn value(&self, text: &str) -> Result<f64, String> {
        let value: f64 = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
        let is_integer = value.fract() == 0.0 && value >= 1.0;
        let fits = match self {
            Self::N => is_integer && value <= f64::from(i32::MAX),
            Self::Threads | Self::Ranks => is_integer && value <= 4096.0,
            Self::Length | Self::Radius | Self::Neighbours => value.is_finite() && value > 0.0,
            Self::Parameter(_) => value.is_finite(),
        };
        if fits { Ok(value) } else { Err(format!("{text} is no value of {self}")) }
    }

    #[must_use]
    pub(crate) fn set(&self, mut job: Job, value: f64) -> Job {
        match (self, &mut job.scene) {
            (Self::N, _) => job.scene = job.scene.with_n(value as usize),
            (Self::Neighbours, scene) => {
                *scene = Scene::Spread { n: scene.n(), neighbours: value };
            }
            (Self::Length, Scene::Hard { side, .. }) => *side = value,
            (Self::Radius, Scene::Hard { radius, .. }) => *radius = value,
            (Self::Threads, _) => job.program.threads = Some(value as usize),
            (Self::Ranks, _) => job.program.ranks = Some(value as usize),
            (Self::Parameter(name), _) => {
                job.program.parameters.retain(|(known, _)| known != name);
                job.program.parameters.push((name.clone(), value));
            }
            (Self::Length | Self::Radius, _) => {}
        }
        job
    }

    /// Returns the value in the job; NaN if the job does not have the quantity.
    pub(crate) fn of(&self, job: &Job) -> f64 {
        match (self, &job.scene) {
            (Self::N, scene) => scene.n() as f64,
            (Self::Neighbours, Scene::Spread { neighbours, .. }) => *neighbours,
            (Self::Length, Scene::Hard { side, .. }) => *side,
            (Self::Radius, Scene::Hard { radius, .. }) => *radius,
            (Self::Threads, _) => job.threads() as f64,
            (Self::Ranks, _) => job.ranks().unwrap_or(1) as f64,
            (Self::Parameter(name), _) => {
                let known = job.program.parameters.iter().find(|(known, _)| known == name);
                known.map_or(f64::NAN, |(_, value)| *value)
            }
            _ => f64::NAN,
        }
    }

    /// Whether the quantity is a number of workers that share the work.
    pub(crate) fn is_workers(&self) -> bool {
        matches!(self, Self::Threads | Self::Ranks)
    }

    /// Whether the quantity is the number of threads in a workgroup of a device.
    pub(crate) fn is_workgroup(&self) -> bool {
        matches!(self, Self::Parameter(name) if name == "workgroup")
    }

    /// Returns the quantity's name in a chart.
    pub(crate) fn label(&self) -> String {
        match self {
            Self::N => "discs or particles N".into(),
            Self::Length => "side L of the square".into(),
            Self::Radius => "radius r".into(),
            Self::Neighbours => "particles in the area of a cutoff disc".into(),
            _ if self.is_workgroup() => "threads of a workgroup".into(),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for Varied {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::N => "n",
            Self::Length => "length",
            Self::Radius => "radius",
            Self::Neighbours => "neighbours",
            Self::Threads => "threads",
            Self::Ranks => "ranks",
            Self::Parameter(name) => name,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn over(text: &str) -> Over {
        text.parse().unwrap()
    }

    fn job() -> Job {
        Job::new("solution7:planned".parse().unwrap(), Scene::usual(None, true))
    }

    #[test]
    fn a_quantity_is_read_with_its_values() {
        let radius = over("radius=1,2.5");
        assert_eq!(radius.varied, Varied::Radius);
        assert_eq!(radius.values(&job().program).unwrap(), [1.0, 2.5]);
        assert_eq!(over("windows=1,8").varied, Varied::Parameter("windows".into()));
        for text in ["", "=1", "n=0", "n=1.5", "threads=none", "radius=-1", "length=inf", "n=1,"] {
            assert!(text.parse::<Over>().is_err(), "{text}");
        }
    }

    #[test]
    fn the_report_has_values_where_nobody_gives_any() {
        let values = |text: &str, lab: &str| over(text).values(&lab.parse().unwrap());
        assert_eq!(values("n", "solution7").unwrap().last(), Some(&50_000.0));
        assert_eq!(values("radius", "solution8").unwrap().len(), 7);
        assert!(values("radius", "solution2").is_err());
        assert!(values("ranks", "solution7").is_err());
        assert!(values("n", "solution2").is_err());
        assert!(values("windows", "solution7").is_err());
    }

    #[test]
    fn a_value_is_set_in_its_job() {
        assert_eq!(Varied::N.set(job(), 7.0).scene, Scene::usual(Some(7), true));
        let wide = Varied::Length.set(job(), 9.0).scene;
        assert!(matches!(wide, Scene::Hard { n: 10_000, side: 9.0, .. }));
        assert_eq!(Varied::Threads.set(job(), 2.0).threads(), 2);
        let windows = over("windows").varied.set(job(), 8.0);
        assert_eq!(windows.program.to_string(), "solution7:planned,windows=8");
        for (name, value) in [("n", 7.0), ("length", 9.0), ("radius", 2.5), ("windows", 8.0)] {
            let varied = over(name).varied;
            assert_eq!(varied.of(&varied.set(job(), value)), value, "{name}");
        }
    }
}
