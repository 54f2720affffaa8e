//! `cargo lab fault`: which line of a known-wrong program is wrong, and why?
//!
//! What is asked was written with the kit (see [`fault`]): a class's kit has no known-wrong programs to run.

use std::collections::BTreeSet;
use std::process::ExitCode;

use anyhow::{Context, Result, anyhow, ensure};
use clap::Args;

use crate::memory::{recall, remember};
use crate::tasks::open_todos;
use lab_kit::answers::{RegionId, Task};
use lab_kit::fault::{self, Fault};
use lab_kit::page::folded;
use lab_kit::{Kit, Lab};

/// Find the fault in a program that compiles and is wrong: which line is it, and why?
///
/// Shows a known-wrong answer to a task that you have done, and what a test says of it. What you find is counted in
/// 'cargo lab list', and worth no points.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 3
    lab: Lab,
    /// Your answer
    #[arg(value_parser = ["a", "b", "c", "d"])]
    answer: Option<String>,
    /// This fault of the lab [default: the first that you have not found]
    #[arg(long, value_name = "N")]
    number: Option<usize>,
}

/// How many faults of a lab somebody has found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Found {
    pub(crate) found: usize,
    pub(crate) of: usize,
}

impl Found {
    /// Those of one lab.
    pub(crate) fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let (faults, known) = (fault::read(kit, lab)?, found(kit));
        let found = faults.iter().filter(|fault| known.contains(&key(fault))).count();
        Ok(Self { found, of: faults.len() })
    }
}

/// Shows a fault, or judges an answer.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let faults = fault::read(kit, lab)?;
    ensure!(
        !faults.is_empty(),
        "lab {lab} has no fault to find here; a class gets those of a lab with its next lab"
    );
    let known = found(kit);
    let open = open_todos(kit, lab)?;
    let Some(at) = choose(&faults, &known, &open, options.number)? else {
        println!(
            "You have found all {} faults of lab {lab}. --number 1 shows the first again.",
            faults.len()
        );
        return Ok(ExitCode::SUCCESS);
    };
    let fault = &faults[at];
    let again = options.number.map(|number| format!(" --number {number}")).unwrap_or_default();
    let Some(answer) = options.answer else {
        print(fault, at, faults.len());
        println!("Your answer: cargo lab fault {lab}{again} a (or b, c, d)");
        return Ok(ExitCode::SUCCESS);
    };
    let chosen = answer.bytes().next().map_or(0, |letter| usize::from(letter - b'a'));
    let choice = fault.choices.get(chosen).context("there is no such answer")?;
    if let Some(refutation) = &choice.refutation {
        print!("{}", folded(&format!("Not line {}: ", choice.line), refutation));
        return Ok(ExitCode::FAILURE);
    }
    print!("{}", folded(&format!("Found, in line {}: ", choice.line), &fault.story));
    remember(kit, FOUND, &with(known, fault))?;
    let Found { found, of } = Found::of(kit, lab)?;
    println!("{found} of {of} faults of lab {lab} found.");
    Ok(ExitCode::SUCCESS)
}

/// The position of the fault that is asked for, or of the first that is not found; none if all are. What shows
/// much of an answer is not shown while its task is open.
fn choose(
    faults: &[Fault],
    known: &BTreeSet<String>,
    open: &[Task],
    number: Option<usize>,
) -> Result<Option<usize>> {
    let asked = match number {
        Some(number) => {
            let none = format!("there are faults 1 to {}, and no {number}", faults.len());
            vec![number.checked_sub(1).filter(|at| *at < faults.len()).context(none)?]
        }
        None => (0..faults.len()).filter(|at| !known.contains(&key(&faults[*at]))).collect(),
    };
    let mut needed = Vec::new();
    for at in &asked {
        let task = faults[*at].region.parse::<RegionId>().map_err(|e| anyhow!(e))?.task;
        if !open.contains(&task) {
            return Ok(Some(*at));
        }
        needed.push(task.to_string());
    }
    ensure!(
        asked.is_empty(),
        "do task {} first: the fault is in an answer to it",
        needed.join(" or ")
    );
    Ok(None)
}

fn print(fault: &Fault, at: usize, of: usize) {
    let (region, title) = (&fault.region, &fault.title);
    let head = format!("Fault {} of {of}, in an answer to task {region}, {title}.", at + 1);
    print!("{}", folded("", &head));
    println!("It compiles. One line is wrong, or one is missing.\n");
    for (line, number) in fault.code.lines().zip(1..) {
        print!("{}", folded(&format!("{number:4}  "), line));
    }
    let says = format!("The right program passes {}, which says of this one:", fault.test);
    print!("\n{}", folded("", &says));
    fault.message.lines().for_each(|line| print!("{}", folded("    ", line)));
    println!("\nWhich line, and why?");
    for (choice, letter) in fault.choices.iter().zip('a'..) {
        print!("{}", folded(&format!("  {letter}  line {:2}: ", choice.line), &choice.why));
    }
    println!();
}

/// What is remembered of a fault that somebody found.
fn key(fault: &Fault) -> String {
    format!("{} {}", fault.region, fault.name)
}

fn with(mut known: BTreeSet<String>, fault: &Fault) -> BTreeSet<String> {
    known.insert(key(fault));
    known
}

/// The faults that somebody found.
fn found(kit: &Kit) -> BTreeSet<String> {
    recall(kit, FOUND).unwrap_or_default()
}

const FOUND: &str = "faults.json";

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{choose, with};
    use lab_kit::fault::Fault;

    fn faults() -> [Fault; 2] {
        [("3.2", "a"), ("3.9b", "b")].map(|(region, name)| Fault {
            name: name.into(),
            region: region.into(),
            title: String::new(),
            code: String::new(),
            test: String::new(),
            message: String::new(),
            choices: Vec::new(),
            story: String::new(),
        })
    }

    #[test]
    fn the_first_that_is_not_found_and_whose_task_is_done() {
        let (faults, none) = (faults(), BTreeSet::new());
        let tasks = ["3.2", "3.9"].map(|task| task.parse().unwrap());
        let choose = |known: &_, open: &[_], number| choose(&faults, known, open, number);
        assert_eq!(choose(&none, &[], None).unwrap(), Some(0));
        assert_eq!(choose(&none, &tasks[..1], None).unwrap(), Some(1));
        let refused = choose(&none, &tasks, None).unwrap_err().to_string();
        assert_eq!(refused, "do task 3.2 or 3.9 first: the fault is in an answer to it");
        let one = with(none, &faults[0]);
        assert_eq!(choose(&one, &[], None).unwrap(), Some(1));
        assert_eq!(choose(&one, &[], Some(1)).unwrap(), Some(0), "once more");
        assert!(choose(&one, &tasks[1..], None).is_err());
        assert_eq!(choose(&with(one, &faults[1]), &tasks, None).unwrap(), None);
    }

    #[test]
    fn a_number_that_is_none_is_refused() {
        for number in [0, 3] {
            let error = choose(&faults(), &BTreeSet::new(), &[], Some(number)).unwrap_err();
            assert_eq!(error.to_string(), format!("there are faults 1 to 2, and no {number}"));
        }
    }
}
