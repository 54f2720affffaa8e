//! `cargo lab speed`: compares a lab's innermost loop with a fast loop.

use anyhow::{Result, ensure};
use clap::Args;
use lab_kit::facts::Race;
use lab_kit::program::Program;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab};

use super::count::{per, profile};
use crate::cachegrind::{By, Caches, Counts};
use crate::clock::{Ratio, times_longer};
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::runner::Runner;
use crate::scene::Scene;

/// Test whether a lab's innermost loops are as fast as they can be
///
/// Each loop takes turns with a second loop, which does the same work without unpredictable
/// branches, or without the slow part. A fast loop takes the same time as the second loop. Both are
/// programs of the lab, so no solution is needed, and a loop can be timed as soon as its task is
/// done. A loop is slow if it takes more than 1.5 times as long, by the shortest takes and by the
/// medians, and if the ranges of the two do not overlap. If valgrind is installed, the command also
/// counts the mispredicted branches and the instructions of a slow loop.
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

/// Ratio of times above which a loop is slow.
const SLOW: f64 = 1.5;

/// Number of takes in turns, each of about a tenth of a second.
const EFFORT: Effort = Effort { steps: None, rounds: 7, seconds: 1.4 };

/// Greatest number of passes through a loop. A tenth of a second never needs more.
const MOST_PASSES: u64 = 1_000_000;

/// Number of passes that are counted, and number of passes before them.
const COUNTED: u64 = 10;

/// Times the loops, and for each slow loop prints the reason why it is slow.
pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let Options { lab, solution, caches } = options;
    let races = kit.facts(lab)?.races;
    ensure!(!races.is_empty(), "no single loop of lab {lab} is timed");
    let program = Program::new(lab, solution)?;
    let package = program.package();
    let mut runner = Runner::build(kit, &[program])?;
    let mut slow = Vec::new();
    for race in &races {
        let own = job(&package, &race.program, race.n)?;
        let other = job(&package, &race.against, race.n)?;
        match ratio(&runner, &own, &other) {
            Ok(ratio) if is_slow(ratio) => slow.push((race, own, other, ratio)),
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
    for (race, own, other, ratio) in &slow {
        let mut text = race.slow.replace("{}", &times_longer(ratio.of_minima));
        if counts {
            text += &why(counted(&runner, own)?, counted(&runner, other)?, &race.of);
        }
        say(race, "slow: ", &text);
    }
    if !slow.is_empty() && !counts {
        println!(
            "Branches that are guessed wrong are counted where valgrind is installed; here it is not."
        );
    }
    Ok(())
}

/// Makes the job for a program with one loop, such as `alone:drift` of package `lab10`.
fn job(package: &str, program: &str, n: usize) -> Result<Job> {
    let program = format!("{package}-{program}").parse().map_err(anyhow::Error::msg)?;
    Ok(Job::new(program, Scene::Soft { n }))
}

fn say(race: &Race, verdict: &str, text: &str) {
    print!("{}", folded(&format!("{:8} {verdict}", race.task), text));
}

/// Measures the ratio of a loop's times to the times of the second loop.
fn ratio(runner: &Runner, own: &Job, other: &Job) -> Result<Ratio> {
    let fit = Fit::Each { most: MOST_PASSES, affordable: false };
    let timings = EFFORT.run(runner, vec![own.clone(), other.clone()], fit)?.timings;
    Ok(timings[0].nanoseconds.over(timings[1].nanoseconds))
}

fn is_slow(ratio: Ratio) -> bool {
    ratio.decided && ratio.of_minima > SLOW && ratio.of_medians > SLOW
}

fn counted(runner: &Runner, job: &Job) -> Result<Counts> {
    let job = Job { steps: COUNTED, ..job.clone() };
    Ok(per(&job, profile(runner, &job, 1, By::Function)?.total()))
}

/// Explains the time by mispredicted branches, or else by instructions, compared with the second
/// loop.
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
        for (of_minima, of_medians, decided, slow) in [
            (1.7, 1.6, true, true),
            (1.7, 1.6, false, false),
            (1.4, 1.6, true, false),
            (1.6, 1.4, true, false),
        ] {
            assert_eq!(is_slow(Ratio { of_minima, of_medians, decided }), slow);
        }
    }

    #[test]
    fn wrong_guesses_explain_more_than_instructions() {
        let other = [10.0, 0.0, 0.0, 0.0];
        for (instructions, wrong, words) in [
            (16.0, 0.091, "; it guesses a branch wrong 9 times in 100 pairs"),
            (16.0, 0.0, "; it takes 1600 instructions for 100 pairs, and the other 1000"),
            (11.0, 0.0, ""),
        ] {
            assert_eq!(why([instructions, 0.0, 0.0, wrong], other, "pairs"), words);
        }
    }
}
