//! Points of a lab's tasks and measures, from its [facts](crate::facts).

use std::collections::BTreeMap;

use anyhow::{Result, ensure};

use crate::facts::{Facts, Timed};
use crate::kit::Kit;
use crate::lab::Lab;

/// Points of all tasks of a lab together.
const WHOLE: f64 = 100.0;

/// Most points of a single task or measure. A larger number is a typing error.
const MOST: f64 = 1000.0;

impl Facts {
    /// Returns the measures of times, with their points.
    pub fn timed(&self) -> impl Iterator<Item = &Timed> {
        [&self.complexity, &self.scaling, &self.speed].into_iter().flatten()
    }

    /// Whether entries of the lab take part in a contest.
    pub fn has_contest(&self) -> bool {
        !self.goals.is_empty()
    }

    /// Returns the rubric of the core tasks: they are worth a hundred points together, and other
    /// tasks and times are worth nothing.
    pub fn core(mut self) -> Self {
        (self.complexity, self.scaling, self.speed) = (None, None, None);
        let sum: f64 =
            self.tasks.values().filter(|task| !task.optional).map(|task| task.points).sum();
        for task in self.tasks.values_mut() {
            task.points = if task.optional { 0.0 } else { task.points * WHOLE / sum };
        }
        self
    }

    /// Prints a warning if the points look like a mistake.
    pub fn warn(&self, lab: Lab) {
        if let Some(warning) = self.warning(lab) {
            eprintln!("{warning}");
        }
    }

    /// Returns a warning if the tasks are not worth a hundred points together.
    fn warning(&self, lab: Lab) -> Option<String> {
        let sum: f64 = self.tasks.values().map(|task| task.points).sum();
        let file = format!("solutions/lab{lab}/lab.toml");
        ((sum - WHOLE).abs() > 1e-6).then(|| {
            format!("warning: in {file} the tasks of lab {lab} add up to {sum}, not {WHOLE}")
        })
    }
}

/// Reads the facts of a lab that can be graded.
///
/// # Errors
/// If the facts cannot be read, name no task, or contain points outside 0 to [`MOST`].
pub fn read(kit: &Kit, lab: Lab) -> Result<Facts> {
    let facts = kit.facts(lab)?;
    let file = format!("solutions/lab{lab}/lab.toml");
    ensure!(!facts.tasks.is_empty(), "{file} names no task: lab {lab} cannot be graded");
    let points = facts.tasks.values().map(|task| task.points);
    for points in points.chain(facts.timed().map(|timed| timed.points)) {
        let possible = (0.0..=MOST).contains(&points);
        ensure!(possible, "{file}: points = {points}: a task has 0 to {MOST} points");
    }
    for (id, task) in &facts.tasks {
        let share = task.partial;
        let some = (0.0..=1.0).contains(&task.partial);
        ensure!(some, "{file}: partial: task {id} cannot have a share of {share}");
    }
    Ok(facts)
}

/// Reads the facts of all labs.
pub fn all(kit: &Kit) -> Result<BTreeMap<Lab, Facts>> {
    kit.solutions().into_iter().map(|lab| Ok((lab, read(kit, lab)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::{all, read};
    use crate::answers::RegionId;
    use crate::facts::Facts;
    use crate::kit::Kit;

    #[test]
    fn tasks_are_worth_a_hundred_points() {
        let kit = Kit::find().unwrap();
        for (lab, rubric) in all(&kit).unwrap() {
            assert_eq!(rubric.warning(lab), None);
            assert_eq!(rubric.clone().core().warning(lab), None);
            for task in rubric.tasks.keys() {
                let id: RegionId = task.parse().unwrap();
                assert_eq!(id.task.lab, lab, "{task}");
            }
            assert!(rubric.races.iter().all(|race| rubric.tasks.contains_key(&race.task)));
            let variants = &rubric.variants;
            for task in variants.iter().filter_map(|variant| variant.task.as_ref()) {
                assert!(rubric.tasks.contains_key(task), "lab {lab} has no task {task}");
            }
            for timed in rubric.timed() {
                let known = variants.iter().any(|variant| variant.name == timed.variant);
                assert!(known && timed.points > 0.0, "lab {lab} has no variant {}", timed.variant);
            }
        }
    }

    /// Reads the rubric of a lab 3 with these points for 3.1.
    fn with(points: &str) -> anyhow::Result<Facts> {
        let folder = tempfile::tempdir().unwrap();
        let facts = format!(
            "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[tasks]\n\
             '3.1' = {{ points = {points}, hours = 1.0, mark = 1, section = 'x' }}\n"
        );
        let kit = Kit::of_files(folder.path(), &[("solutions/lab3/lab.toml", &facts)]);
        read(&kit, "3".parse().unwrap())
    }

    #[test]
    fn a_share_is_a_part_of_a_task() {
        for (share, well) in [("0.5", true), ("2.0", false), ("-0.5", false)] {
            let rubric = with(&format!("100, partial = {share}"));
            assert_eq!(rubric.is_ok(), well, "{share}");
        }
    }

    #[test]
    fn points_outside_the_limits_are_refused() {
        for points in ["-5", "nan", "inf", "1e308"] {
            let error = with(points).unwrap_err().to_string();
            assert!(error.contains("0 to 1000 points"), "{points}: {error}");
        }
    }
}
