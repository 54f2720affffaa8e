//! What a student is asked about a known-wrong solution: `tests/wrong/labN/NAME.toml` beside `NAME.rs`.
//!
//! ```toml
//! [[choice]]
//! line = "for bin in 1..bins {"        # a line of the function, without its indent
//! why = "The loop leaves out the first bin."
//! refutation = "The first bin is …"    # of the three that are wrong
//! ```
//!
//! With the function and with what a test says it becomes `labs/labN/faults/NAME.json`.

use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use super::Bench;
use lab_kit::answers::{MarkedFile, Part};
use lab_kit::fault::{self, Choice, Fault};
use lab_kit::files::{read_toml, write_file};
use lab_kit::harness::Outcome;
use lab_kit::wrong::Wrong;
use lab_kit::{Kit, Lab};

#[derive(Deserialize)]
struct Questions {
    choice: Vec<Question>,
}

#[derive(Deserialize)]
struct Question {
    line: String,
    why: String,
    refutation: Option<String>,
}

impl Bench<'_> {
    /// Writes the fault that is to be found in a wrong solution, or says that what is written has gone stale.
    pub(super) fn fault(
        &self,
        files: &[MarkedFile],
        wrong: &Wrong,
        outcome: &Outcome,
    ) -> Result<Option<String>> {
        let Some(fault) = ask(self.kit, self.lab, files, wrong, outcome)? else { return Ok(None) };
        let path = format!("labs/lab{}/faults/{}.json", self.lab, wrong.name);
        if self.record {
            write_file(&self.kit.path(&path), serde_json::to_string_pretty(&fault)? + "\n")?;
            return Ok(None);
        }
        let written = fault::read(self.kit, self.lab)?;
        let is_there = written.iter().any(|written| is_of_a_run(written, &fault));
        let stale =
            format!("{path} is stale: 'cargo lab prove --lab {} --record' writes it", self.lab);
        Ok((!is_there).then_some(stale))
    }
}

/// The file of what is asked about a wrong solution, if anything is.
pub(super) fn questions(kit: &Kit, lab: Lab, wrong: &Wrong) -> PathBuf {
    kit.path(format!("tests/wrong/lab{lab}/{}.toml", wrong.name))
}

/// Whether this is what was written. Of the test's message the first line counts, without its numbers: others
/// depend on which thread or rank comes first.
fn is_of_a_run(written: &Fault, fault: &Fault) -> bool {
    let told = |fault: &Fault| {
        let mut message = fault.message.lines().next().unwrap_or_default().to_owned();
        message.retain(|c| !c.is_ascii_digit());
        Fault { message, ..fault.clone() }
    };
    told(written) == told(fault)
}

/// What is asked about a wrong solution; nothing if no questions lie beside it.
fn ask(
    kit: &Kit,
    lab: Lab,
    files: &[MarkedFile],
    wrong: &Wrong,
    outcome: &Outcome,
) -> Result<Option<Fault>> {
    let path = questions(kit, lab, wrong);
    if !path.is_file() {
        return Ok(None);
    }
    let Questions { choice } = read_toml(&path)?;
    let (title, code) = function(files, wrong).with_context(|| path.display().to_string())?;
    let number_of = |line: &str| {
        let mut found = code.lines().zip(1..).filter(|(text, _)| text.trim() == line);
        let (first, second) = (found.next(), found.next());
        ensure!(second.is_none(), "{}: there are two lines '{line}'", path.display());
        Ok(first.with_context(|| format!("{}: there is no line '{line}'", path.display()))?.1)
    };
    let of = |Question { line, why, refutation }| {
        Ok(Choice { line: number_of(&line)?, why, refutation })
    };
    let mut choices: Vec<Choice> = choice.into_iter().map(of).collect::<Result<_>>()?;
    choices.sort_by_key(|choice| choice.line);
    let right = choices.iter().filter(|choice| choice.refutation.is_none()).count();
    let shape = (choices.len(), right);
    ensure!(shape == (4, 1), "{}: four choices, one without refutation", path.display());
    Ok(Some(Fault {
        name: wrong.name.clone(),
        region: wrong.region.to_string(),
        title,
        code,
        test: outcome.test.clone(),
        message: without_locations(&outcome.message),
        choices,
        story: wrong.story.clone(),
    }))
}

/// A message without lines of the solution: the program that ran has all wrong answers in it, and other lines.
fn without_locations(message: &str) -> String {
    let mut parts = message.split(" (solutions/");
    let begun = parts.next().unwrap_or_default().to_owned();
    begun
        + &parts.map(|part| part.split_once(')').map_or(part, |(_, rest)| rest)).collect::<String>()
}

/// The title of a wrong solution's region, and the function around it, with the wrong answer in it.
fn function(files: &[MarkedFile], wrong: &Wrong) -> Option<(String, String)> {
    let mut files = files.iter().map(|file| &file.parts);
    let (parts, at, region) = files.find_map(|parts| {
        parts.iter().enumerate().find_map(|(at, part)| match part {
            Part::Answer(region) if region.id == wrong.region => Some((parts, at, region)),
            _ => None,
        })
    })?;
    let text = |parts: &[Part]| parts.iter().map(Part::text).collect::<String>();
    let (before, after) = (text(&parts[..at]), text(&parts[at + 1..]));
    let before: Vec<&str> = before.lines().collect();
    let begins = |line: &&str| line.split_whitespace().take(2).any(|word| word == "fn");
    let head = &before[before.iter().rposition(begins)?..];
    let outer = indent(head[0]);
    let end = format!("{:outer$}}}", "");
    let tail = after.lines().position(|line| line == end)?;
    let inner = " ".repeat(region.body.lines().find(|line| !line.is_empty()).map(indent)? - outer);
    let own = |line: &str| if line.is_empty() { String::new() } else { format!("{inner}{line}") };
    let given = |line: &str| line.get(outer..).unwrap_or_default().to_owned();
    let lines = head.iter().map(|line| given(line)).chain(wrong.body.lines().map(own));
    let lines: Vec<String> = lines.chain(after.lines().take(tail + 1).map(given)).collect();
    Some((region.title.clone(), lines.join("\n") + "\n"))
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{ask, without_locations};
    use lab_kit::harness::{Outcome, Verdict};
    use lab_kit::{Kit, answers, fault, wrong};

    #[test]
    fn lines_of_another_file_are_not_told() {
        let message = "  rank 0: Gatherv of root 0 (solutions/lab5/src/root.rs, line 39)\n  rank 1: none (yet)";
        let left = "  rank 0: Gatherv of root 0\n  rank 1: none (yet)";
        assert_eq!(without_locations(message), left);
    }

    #[test]
    fn what_is_written_fits_its_sources() {
        let kit = Kit::find().unwrap();
        for lab in kit.solutions() {
            let written = fault::read(&kit, lab).unwrap();
            let files = answers::read_solution(&kit, lab).unwrap();
            let mut asked = BTreeSet::new();
            for wrong in wrong::read(&kit, lab).unwrap() {
                let there = written.iter().find(|fault| fault.name == wrong.name);
                // What the test says, only a proof knows.
                let (test, message) = there
                    .map(|fault| (fault.test.clone(), fault.message.clone()))
                    .unwrap_or_default();
                let outcome = Outcome { test, verdict: Verdict::Failed, message };
                if let Some(fault) = ask(&kit, lab, &files, &wrong, &outcome).unwrap() {
                    assert_eq!(there, Some(&fault), "'cargo lab prove --lab {lab} --record'");
                    assert_eq!(fault.test, wrong.fails[0]);
                    asked.insert(fault.name);
                }
            }
            assert!(written.iter().all(|fault| asked.contains(&fault.name)), "lab {lab}");
        }
    }
}
