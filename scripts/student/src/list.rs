//! `cargo lab list`: all labs, their tasks, and which are done.

use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use serde::Serialize;

use crate::results::Results;
use crate::tasks::{self, Progress, State, print_tasks};
use crate::test;
use lab_kit::process;
use lab_kit::system;
use lab_kit::{Kit, Lab};

/// List the labs and their tasks, and which of them are done
///
/// What is done is what the last 'cargo lab test' said.
#[derive(Args)]
pub(crate) struct Options {
    /// Only this lab [default: all]
    lab: Option<Lab>,
    /// Run the tests first, instead of believing the last run
    #[arg(long)]
    run: bool,
    /// Print the list as JSON
    #[arg(long)]
    json: bool,
}

/// A lab, with what is known of its tasks.
#[derive(Serialize)]
pub(crate) struct Overview {
    /// The lab.
    pub(crate) lab: Lab,
    /// Its title.
    pub(crate) title: String,
    /// Whether its tests have ever run.
    pub(crate) tested: bool,
    /// Whether its source is still what was tested.
    pub(crate) fresh: bool,
    /// Its tasks.
    pub(crate) tasks: Vec<Progress>,
}

impl Overview {
    /// What the last run of the lab's tests said.
    pub(crate) fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let results = Results::read(kit, lab);
        let fresh = results.as_ref().map(|results| results.is_fresh(kit, lab)).transpose()?;
        let outcomes = results.as_ref().map_or(&[][..], |results| &results.outcomes);
        Ok(Self {
            lab,
            title: kit.title(lab),
            tested: results.is_some(),
            fresh: fresh == Some(true),
            tasks: tasks::progress(kit, lab, outcomes)?,
        })
    }

    /// How many of its tasks are done.
    pub(crate) fn done(&self) -> usize {
        self.tasks.iter().filter(|progress| progress.state == State::Done).count()
    }
}

/// Prints the list.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let labs = match options.lab {
        Some(lab) => {
            kit.expect_starter(lab)?;
            vec![lab]
        }
        None => kit.starters()?,
    };
    let mut overviews = Vec::new();
    for lab in labs {
        let missing = system::missing(kit, lab)?;
        if options.run
            && missing.is_none()
            && let Err(errors) = test::run_tests(kit, lab, None)?
        {
            eprintln!(
                "lab {lab} does not compile ({} errors): 'cargo lab test {lab}' shows why",
                errors.len()
            );
        }
        overviews.push((Overview::of(kit, lab)?, missing));
    }
    if options.json {
        let overviews: Vec<_> = overviews.iter().map(|(overview, _)| overview).collect();
        println!("{}", serde_json::to_string_pretty(&overviews)?);
        return Ok(ExitCode::SUCCESS);
    }
    for (index, (overview, missing)) in overviews.iter().enumerate() {
        if index > 0 {
            println!();
        }
        let Overview { lab, title, tested, fresh, tasks } = overview;
        let state = match (missing, tested, fresh) {
            (Some(what), ..) => format!("needs {what}"),
            (_, false, _) => format!("not tested yet: cargo lab test {lab}"),
            (_, _, true) => format!("{} of {} tasks done", overview.done(), tasks.len()),
            (_, _, false) => format!(
                "{} of {} tasks done, before your last change",
                overview.done(),
                tasks.len()
            ),
        };
        println!("Lab {lab}, {title}: {state}");
        print_tasks(tasks);
    }
    Ok(ExitCode::SUCCESS)
}
