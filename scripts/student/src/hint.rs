//! `cargo lab hint`: shows a hint, in three steps.

use std::collections::BTreeMap;
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use crate::memory::{recall, remember};
use crate::tasks::expect_task;
use lab_kit::Kit;
use lab_kit::answers::Task;
use lab_kit::facts::TaskFacts;
use lab_kit::task_list::{self, TIERS};
use lab_kit::terminal::folded;

/// Get a hint for a task: first a nudge, then the idea, then nearly the answer
///
/// Each call shows the next of three hints. After the third, the third is shown again.
#[derive(Args)]
pub(crate) struct Options {
    /// The task, such as 1.3
    task: Task,
    /// Show this hint, 1 to 3, without moving on to the next
    #[arg(long, value_name = "1-3", value_parser = clap::value_parser!(u8).range(1..=TIERS as i64))]
    tier: Option<u8>,
}

/// Shows the next hint.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let task = options.task;
    kit.expect_starter(task.lab)?;
    expect_task(kit, task)?;
    let mut all = task_list::read(kit, task.lab)?.into_iter();
    let facts = all.find(|(own, _)| *own == task).map(|(_, facts)| facts);
    let facts = facts.with_context(|| format!("task {task} has no hints yet"))?;
    let shown = options.tier.map_or_else(|| next(kit, task), |tier| Ok(usize::from(tier)))?;
    print(task, &facts, shown);
    Ok(ExitCode::SUCCESS)
}

fn print(task: Task, facts: &TaskFacts, tier: usize) {
    print!("{}", folded(&format!("Task {task}: "), &facts.title));
    println!("Hint {tier} of {TIERS}\n");
    facts.hints[tier - 1].lines().for_each(|line| print!("{}", folded("", line)));
    println!();
    let next = match tier {
        TIERS => {
            "That was the last hint. The chapter explains the task in full; '--tier 1' starts over."
        }
        _ => "Not enough? The same command shows the next hint.",
    };
    print!("{}", folded("", next));
}

/// Returns the tier after the last tier that was shown.
fn next(kit: &Kit, task: Task) -> Result<usize> {
    const SHOWN: &str = "hints.json";
    // If the record cannot be read, the first hint is shown again, which does little harm.
    let mut shown: BTreeMap<String, usize> = recall(kit, SHOWN).unwrap_or_default();
    let tier = shown.entry(task.to_string()).or_default();
    *tier = (*tier + 1).min(TIERS);
    let tier = *tier;
    remember(kit, SHOWN, &shown)?;
    Ok(tier)
}

#[cfg(test)]
mod tests {
    use super::next;
    use lab_kit::Kit;

    #[test]
    fn hints_come_one_after_the_other() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        let task = "1.1".parse().unwrap();
        let other = "1.2".parse().unwrap();
        let tiers: Vec<_> = (0..4).map(|_| next(&kit, task).unwrap()).collect();
        assert_eq!(tiers, [1, 2, 3, 3]);
        assert_eq!(next(&kit, other).unwrap(), 1);
    }
}
