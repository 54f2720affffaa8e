//! The tasks of a lab in order, with the facts about each task.

use anyhow::{Result, anyhow, ensure};

use crate::answers::Task;
use crate::facts::{Facts, TaskFacts};
use crate::kit::Kit;
use crate::lab::Lab;

/// Number of hints for every task.
pub const TIERS: usize = 3;

/// Returns the tasks of a lab with their facts, in order; empty if the lab has no facts.
///
/// # Errors
/// If the facts cannot be read, or if a task does not have three hints.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<(Task, TaskFacts)>> {
    if kit.facts_file(lab).is_none() {
        return Ok(Vec::new());
    }
    of(kit.facts(lab)?)
}

fn of(facts: Facts) -> Result<Vec<(Task, TaskFacts)>> {
    let mut all = Vec::new();
    for (id, mut facts) in facts.tasks {
        let found = facts.hints.len();
        ensure!(found == TIERS, "lab.toml: task {id} has {found} hints, not {TIERS}");
        facts.hints.iter_mut().for_each(|hint| *hint = hint.trim().into());
        let task: Task = id.parse().map_err(|error| anyhow!("lab.toml: {error}"))?;
        all.push((task, facts));
    }
    all.sort_by_key(|(task, _)| *task);
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::of;
    use crate::facts::{Facts, TaskFacts};

    fn facts(tasks: &[(&str, &[&str])]) -> Facts {
        let mut facts = Facts::default();
        for (id, hints) in tasks {
            let hints = hints.iter().map(ToString::to_string).collect();
            let task = TaskFacts { title: format!("task {id}"), hints, ..TaskFacts::default() };
            facts.tasks.insert((*id).into(), task);
        }
        facts
    }

    #[test]
    fn tasks_are_in_the_order_of_their_numbers() {
        let three: &[&str] = &["a nudge", "the idea", "nearly"];
        let all = of(facts(&[("7.10", three), ("7.2", three)])).unwrap();
        let titles: Vec<&str> = all.iter().map(|(_, facts)| facts.title.as_str()).collect();
        assert_eq!(titles, ["task 7.2", "task 7.10"]);
        assert_eq!(all[0].1.hints, three);
    }

    #[test]
    fn a_missing_tier_is_an_error() {
        let error = of(facts(&[("1.2", &["x", "y"])])).unwrap_err();
        assert_eq!(error.to_string(), "lab.toml: task 1.2 has 2 hints, not 3");
    }
}
