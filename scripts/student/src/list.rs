//! `cargo lab list`: shows the state of a lab's tasks, or of all labs.

use std::env;
use std::fs;
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use crate::results::{self, Results};
use crate::tasks::{self, Progress, State, print_tasks};
use lab_kit::{Kit, Lab, system};

/// Show how far you have come: a mark for each task of a lab, or of all labs
///
/// The marks are the results of the last 'cargo lab test'.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab [default: the one whose folder you are in, or that you tested last]
    lab: Option<Lab>,
    /// Show all labs, each on a line
    #[arg(long, conflicts_with = "lab")]
    all: bool,
}

/// A lab and the state of its tasks.
pub(crate) struct Overview {
    lab: Lab,
    title: String,
    /// Whether the lab's source has changed since it was tested.
    pub(crate) stale: bool,
    tasks: Vec<Progress>,
    /// Software that must be installed before the lab can run; `None` if nothing is missing.
    missing: Option<&'static str>,
}

impl Overview {
    /// Reads the results of the last run of the lab's tests.
    pub(crate) fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let results = Results::read(kit, lab);
        let fresh = results.as_ref().map(|results| results.is_fresh(kit, lab)).transpose()?;
        let outcomes = results.as_ref().map_or(&[][..], |results| &results.outcomes);
        Ok(Self {
            lab,
            title: kit.title(lab),
            stale: fresh == Some(false),
            tasks: tasks::progress(kit, lab, outcomes)?,
            missing: None,
        })
    }

    /// Returns the number of tasks that are done.
    pub(crate) fn done(&self) -> usize {
        tasks::done(&self.tasks)
    }

    /// Returns the count of finished core tasks as text; empty if the lab has only core tasks.
    fn core(&self) -> String {
        let core: Vec<_> = self.tasks.iter().filter(|task| !task.optional).cloned().collect();
        if core.len() == self.tasks.len() {
            return String::new();
        }
        format!("  core {} of {}", tasks::done(&core), core.len())
    }

    fn note(&self) -> String {
        match self.missing.and_then(|what| what.split(':').next()) {
            Some(what) => format!("  needs {what}"),
            None if self.stale => "  test it again".into(),
            None => String::new(),
        }
    }
}

/// Prints the list.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    if let Some(lab) = options.lab {
        kit.expect_starter(lab)?;
    }
    let labs = match options.lab {
        _ if options.all => kit.starters(),
        Some(lab) => vec![lab],
        None => vec![current(kit)?],
    };
    let mut overviews = Vec::new();
    for lab in labs {
        let missing = system::missing(kit, lab)?;
        overviews.push(Overview { missing, ..Overview::of(kit, lab)? });
    }
    print!("{}", table(&overviews));
    if let ([Overview { tasks, .. }], false) = (&overviews[..], options.all) {
        println!();
        print_tasks(tasks);
        println!("\nAll labs: cargo lab list --all");
    }
    Ok(ExitCode::SUCCESS)
}

/// Returns the lab of the current folder, or else the last tested one, or else the first.
fn current(kit: &Kit) -> Result<Lab> {
    let labs = kit.starters();
    let here = env::current_dir()?;
    if let Some(lab) = labs.iter().find(|lab| here.starts_with(kit.starter(**lab))) {
        return Ok(*lab);
    }
    let tested = labs.iter().filter_map(|lab| {
        let results = fs::metadata(results::file(kit, *lab)).ok()?;
        Some((results.modified().ok()?, *lab))
    });
    tested.max().map(|(_, lab)| lab).or(labs.first().copied()).context("this kit has no labs")
}

fn table(overviews: &[Overview]) -> String {
    let titles = overviews.iter().map(|one| one.title.chars().count()).max().unwrap_or(0);
    let bars = overviews.iter().map(|one| one.tasks.len()).max().unwrap_or(0);
    let mut out = String::new();
    for overview in overviews {
        let Overview { lab, title, tasks, .. } = overview;
        let bar: String = tasks.iter().map(|progress| mark(progress.state)).collect();
        let count = format!("{:2} of {:2}", overview.done(), tasks.len());
        let note = overview.core() + &overview.note();
        out += &format!("{lab:>3}  {title:titles$}  {bar:bars$}  {count}{note}\n");
    }
    let done: usize = overviews.iter().map(Overview::done).sum();
    let all: usize = overviews.iter().map(|overview| overview.tasks.len()).sum();
    let percent = (100 * done).checked_div(all).unwrap_or(0);
    let filled = (30 * done).checked_div(all).unwrap_or(0);
    let bar = "█".repeat(filled) + &"░".repeat(30 - filled);
    out += &format!("\n     {bar}  {done} of {all} tasks, {percent} %\n");
    out += "     █ done   x fails   ░ to do   · not tested\n";
    out
}

/// Returns the character that stands for a task in its lab's progress bar.
fn mark(state: State) -> char {
    match state {
        State::Done => '█',
        State::Failing => 'x',
        State::Todo => '░',
        State::Untested => '·',
    }
}

#[cfg(test)]
mod tests {
    use super::{Overview, table};
    use crate::tasks::Progress;
    use crate::tasks::State;

    fn overview(lab: u8, title: &str, stale: bool, states: &[State]) -> Overview {
        Overview {
            lab: lab.to_string().parse().unwrap(),
            title: title.into(),
            stale,
            tasks: Progress::samples(lab, states),
            missing: (lab == 10).then_some("a driver: scripts/setup.sh installs it"),
        }
    }

    #[test]
    fn a_line_a_lab_and_a_mark_a_task() {
        let mut overviews = [
            overview(1, "all pairs", false, &[State::Done, State::Done, State::Done]),
            overview(2, "bins", true, &[State::Done, State::Failing, State::Todo, State::Todo]),
            overview(10, "fast", false, &[State::Untested]),
        ];
        overviews[1].tasks[3].optional = true;
        assert_eq!(
            table(&overviews),
            "  1  all pairs  ███    3 of  3
  2  bins       █x░░   1 of  4  core 1 of 3  test it again
 10  fast       ·      0 of  1  needs a driver

     ███████████████░░░░░░░░░░░░░░░  4 of 8 tasks, 50 %
     █ done   x fails   ░ to do   · not tested
"
        );
    }

    #[test]
    fn a_kit_without_labs_is_no_trouble() {
        assert!(table(&[]).contains("0 of 0 tasks, 0 %"));
    }
}
