//! Reads the titles of a lab's tasks and their hints from the lab's facts.

use anyhow::{Result, ensure};

use crate::answers::Task;
use crate::facts::Facts;
use crate::kit::Kit;
use crate::lab::Lab;

/// Number of hints for every task.
pub const TIERS: usize = 3;

/// The hints for a task.
#[derive(Debug, PartialEq)]
pub struct Hints {
    /// The task.
    pub task: Task,
    /// Title of the task.
    pub title: String,
    /// Hints, from a nudge to nearly the answer.
    pub tiers: Vec<String>,
}

/// Returns the hints of a lab, in the order of its tasks; empty if the lab has no facts.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Hints>> {
    if !kit.has_facts(lab) {
        return Ok(Vec::new());
    }
    of(&kit.facts(lab)?)
}

fn of(facts: &Facts) -> Result<Vec<Hints>> {
    let mut all = Vec::new();
    for (id, task) in &facts.tasks {
        let found = task.hints.len();
        ensure!(found == TIERS, "lab.toml: task {id} has {found} hints, not {TIERS}");
        let tiers = task.hints.iter().map(|hint| hint.trim().into()).collect();
        let number = id.parse().map_err(|e| anyhow::anyhow!("lab.toml: {e}"))?;
        all.push(Hints { task: number, title: task.title.clone(), tiers });
    }
    all.sort_by_key(|hints| hints.task);
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
        let all = of(&facts(&[("7.10", three), ("7.2", three)])).unwrap();
        let titles: Vec<&str> = all.iter().map(|hints| hints.title.as_str()).collect();
        assert_eq!(titles, ["task 7.2", "task 7.10"]);
        assert_eq!(all[0].tiers, three);
    }

    #[test]
    fn a_missing_tier_is_an_error() {
        let error = of(&facts(&[("1.2", &["x", "y"])])).unwrap_err();
        assert_eq!(error.to_string(), "lab.toml: task 1.2 has 2 hints, not 3");
    }
}
