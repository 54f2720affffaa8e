//! `cargo lab speed`: is a right loop a fast one?

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use lab_kit::facts::Race;
use lab_kit::page::folded;
use lab_kit::program::Program;
use lab_kit::{Kit, Lab};

use super::count::{per, profile};
use crate::cachegrind::{By, Caches, Counts};
use crate::clock::{Ratio, times_longer};
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::runner::Runner;
use crate::scene::Scene;

/// Say of a lab's innermost loops whether they are as fast as they can be
///
/// Each loop takes turns with one that a fast loop is as fast as: the same work where nothing is to be guessed, or
/// without what makes it slow. Both are programs of the lab, so no solution is needed, and a loop can be timed as soon as
/// its task is done. A loop is slow if it takes more than 1.5 times as long, by the shortest takes and by the medians,
/// and the takes of the two lie apart. Where valgrind is installed, the branches that a slow loop guesses wrong are
/// counted, and its instructions.
#[derive(Args)]
pub struct Options {
    /// The lab, such as 10
    lab: Lab,
    /// Time the solution instead of your own work
    #[arg(long)]
    solution: bool,
    #[command(flatten)]
    caches: Caches,
}

/// Times as long as the loop beside it is no noise, and nothing to be content with.
const SLOW: f64 = 1.5;

/// Takes in turns, of about a tenth of a second each.
const EFFORT: Effort = Effort { steps: None, rounds: 7, seconds: 1.4 };

/// No loop needs more passes for that.
const MOST_PASSES: u64 = 1_000_000;

/// Passes that are counted, and those before.
const COUNTED: u64 = 10;

/// Times the loops and says of each what is slow in it.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let Options { lab, solution, caches } = options;
    let races = kit.facts(lab)?.races;
    ensure!(!races.is_empty(), "no loop of lab {lab} is timed by itself");
    let program = Program::new(lab, solution)?;
    let name = program.package();
    let mut runner = Runner::build(kit, &[program])?;
    let jobs = |race: &Race| -> Result<[Job; 2]> {
        let job = |program: &str| -> Result<Job> {
            let program = format!("{name}-{program}").parse().map_err(anyhow::Error::msg)?;
            Ok(Job::new(program, Scene::Soft { n: race.n }))
        };
        Ok([job(&race.program)?, job(&race.against)?])
    };
    let mut slow = Vec::new();
    for race in &races {
        let jobs = jobs(race)?;
        match ratio(&runner, &jobs) {
            Ok(ratio) if is_slow(ratio) => slow.push((race, jobs, ratio)),
            Ok(_) => say(race, "fast: ", "as the chapter has it"),
            Err(error) => {
                let words = format!("{error:#}");
                let why = words.split_once(" failed: ").map_or(&*words, |(_, why)| why);
                say(race, "not timed: ", why);
            }
        }
    }
    let tool = caches.tool(runner.folder());
    let counts = tool.is_ok();
    tool.into_iter().for_each(|tool| runner.under(tool));
    for (race, jobs, ratio) in &slow {
        let mut text = race.slow.replace("{}", &times_longer(ratio.of_minima));
        if counts {
            let [own, other] = [&jobs[0], &jobs[1]].map(|job| counted(&runner, job));
            text += &why(own?, other?, &race.of);
        }
        say(race, "slow: ", &text);
    }
    if !slow.is_empty() && !counts {
        println!(
            "Branches that are guessed wrong are counted where valgrind is installed; here it is not."
        );
    }
    Ok(ExitCode::SUCCESS)
}

fn say(race: &Race, verdict: &str, text: &str) {
    print!("{}", folded(&format!("{:8} {verdict}", race.task), text));
}

/// How many times longer the first takes than the second.
fn ratio(runner: &Runner, jobs: &[Job; 2]) -> Result<Ratio> {
    let fit = Fit::Each { most: MOST_PASSES, affordable: false };
    let records = EFFORT.run(runner, jobs.to_vec(), fit)?.records;
    Ok(records[0].nanoseconds.over(records[1].nanoseconds))
}

fn is_slow(ratio: Ratio) -> bool {
    ratio.decided && ratio.of_minima > SLOW && ratio.of_medians > SLOW
}

fn counted(runner: &Runner, job: &Job) -> Result<Counts> {
    let job = Job { steps: COUNTED, ..job.clone() };
    Ok(per(&job, profile(runner, &job, 1, By::Function)?.total()))
}

/// What a processor does more than for the loop beside it: guess wrong, or else follow instructions.
fn why(own: Counts, other: Counts, of: &str) -> String {
    let [instructions, _, _, wrong] = own;
    if wrong > other[3] + 0.01 {
        return format!("; it guesses a branch wrong {:.0} times in 100 {of}", 100.0 * wrong);
    }
    if instructions > SLOW * other[0] {
        let [own, other] = [instructions, other[0]].map(|each| 100.0 * each);
        return format!("; it takes {own:.0} instructions for 100 {of}, and the other {other:.0}");
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_is_slow_beyond_doubt_or_not_at_all() {
        let ratio = |of_minima, of_medians, decided| Ratio { of_minima, of_medians, decided };
        assert!(is_slow(ratio(1.7, 1.6, true)));
        for quick in [ratio(1.7, 1.6, false), ratio(1.4, 1.6, true), ratio(1.6, 1.4, true)] {
            assert!(!is_slow(quick));
        }
    }

    #[test]
    fn wrong_guesses_explain_more_than_instructions() {
        let loop_of = |instructions, wrong| [instructions, 0.0, 0.0, wrong];
        let (own, other) = (loop_of(16.0, 0.091), loop_of(10.0, 0.0));
        let wrong = "; it guesses a branch wrong 9 times in 100 pairs";
        assert_eq!(why(own, other, "pairs"), wrong);
        let many = "; it takes 1600 instructions for 100 pairs, and the other 1000";
        assert_eq!(why(loop_of(16.0, 0.0), other, "pairs"), many);
        assert_eq!(why(loop_of(11.0, 0.0), other, "pairs"), "");
    }
}
