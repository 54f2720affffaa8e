//! `cargo lab progress`: all labs at a glance.

use std::process::ExitCode;

use anyhow::Result;
use clap::Args;

use crate::list::Overview;
use crate::tasks::State;
use lab_kit::Kit;

/// Show how far you have come: a line for each lab, a mark for each task
///
/// What is done is what the last 'cargo lab test' said; 'cargo lab list' names the tasks.
#[derive(Args)]
pub(crate) struct Options {
    /// Print it as JSON
    #[arg(long)]
    json: bool,
}

/// Prints the table.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let labs = kit.starters()?;
    let overviews = labs.into_iter().map(|lab| Overview::of(kit, lab));
    let overviews = overviews.collect::<Result<Vec<_>>>()?;
    if options.json {
        println!("{}", serde_json::to_string_pretty(&overviews)?);
    } else {
        print!("{}", table(&overviews));
    }
    Ok(ExitCode::SUCCESS)
}

fn table(overviews: &[Overview]) -> String {
    let width = |of: fn(&Overview) -> usize| overviews.iter().map(of).max().unwrap_or(0);
    let (titles, bars) = (width(|o| o.title.chars().count()), width(|o| o.tasks.len()));
    let mut out = String::new();
    for overview in overviews {
        let Overview { lab, title, tested, fresh, tasks } = overview;
        let bar: String = tasks.iter().map(|progress| mark(progress.state)).collect();
        let pad = " ".repeat(bars - tasks.len());
        let note = match (tested, fresh) {
            (true, false) => "  changed since it was tested",
            _ => "",
        };
        let count = format!("{:2} of {:2}", overview.done(), tasks.len());
        out += &format!("{lab:>3}  {title:titles$}  {bar}{pad}  {count}{note}\n");
    }
    let (done, all): (usize, usize) = overviews
        .iter()
        .fold((0, 0), |(done, all), overview| (done + overview.done(), all + overview.tasks.len()));
    let percent = (100 * done).checked_div(all).unwrap_or(0);
    let filled = (30 * done).checked_div(all).unwrap_or(0);
    let bar = "█".repeat(filled) + &"░".repeat(30 - filled);
    out += &format!("\n     {bar}  {done} of {all} tasks, {percent} %\n");
    out += "     █ done   x fails   ░ to do   · not tested\n";
    out
}

/// A task's mark in its lab's bar.
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
    use super::table;
    use crate::list::Overview;
    use crate::tasks::{Progress, State};

    fn overview(lab: u8, title: &str, fresh: bool, states: &[State]) -> Overview {
        let of = |(index, state): (usize, &State)| Progress {
            task: format!("{lab}.{}", index + 1).parse().unwrap(),
            title: "a task".into(),
            state: *state,
            tests: Vec::new(),
        };
        Overview {
            lab: lab.to_string().parse().unwrap(),
            title: title.into(),
            tested: !states.contains(&State::Untested),
            fresh,
            tasks: states.iter().enumerate().map(of).collect(),
        }
    }

    #[test]
    fn a_line_a_lab_and_a_mark_a_task() {
        let overviews = [
            overview(1, "all pairs", true, &[State::Done, State::Done, State::Done]),
            overview(2, "bins", false, &[State::Done, State::Failing, State::Todo, State::Todo]),
            overview(10, "fast", false, &[State::Untested]),
        ];
        assert_eq!(
            table(&overviews),
            "  1  all pairs  ███    3 of  3
  2  bins       █x░░   1 of  4  changed since it was tested
 10  fast       ·      0 of  1

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
