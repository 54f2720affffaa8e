//! What a lab's tasks and measures are worth, from its [facts](crate::facts).

use std::collections::BTreeMap;

use anyhow::{Result, ensure};

pub use crate::facts::Timed;
use crate::kit::Kit;
use crate::lab::Lab;

/// Points of all tasks of a lab together.
const WHOLE: f64 = 100.0;

/// What a lab is worth.
#[derive(Clone, Debug, Default)]
pub struct Rubric {
    /// Points by task, such as `1.3`.
    pub tasks: BTreeMap<String, f64>,
    /// What a task that is wrong can still earn, as a share of its points, 0 to 1: in proportion to the
    /// questions that were answered rightly. Nothing if nothing is said.
    pub partial: BTreeMap<String, f64>,
    /// How the time grows with the number of particles; none if that is not graded.
    pub complexity: Option<Timed>,
    /// What more workers bring.
    pub scaling: Option<Timed>,
    /// How long it takes beside the solution.
    pub speed: Option<Timed>,
    /// Whether `cargo lab speed` times its loops.
    pub has_loops: bool,
}

impl Rubric {
    /// Whether there is anything to time.
    pub fn times_anything(&self) -> bool {
        self.measures().next().is_some()
    }

    fn measures(&self) -> impl Iterator<Item = &Timed> {
        [&self.complexity, &self.scaling, &self.speed].into_iter().flatten()
    }

    /// Says what an instructor may not have meant.
    pub fn warn(&self, lab: Lab) {
        if let Some(warning) = self.warning(lab) {
            eprintln!("{warning}");
        }
    }

    /// Tasks that are not worth a hundred points together, if they are not.
    fn warning(&self, lab: Lab) -> Option<String> {
        let sum: f64 = self.tasks.values().sum();
        let file = format!("solutions/lab{lab}/lab.toml");
        ((sum - WHOLE).abs() > 1e-6).then(|| {
            format!("warning: in {file} the tasks of lab {lab} add up to {sum}, not {WHOLE}")
        })
    }
}

/// The rubric of a lab.
///
/// # Errors
/// The lab's facts cannot be read, name no task, or take points away.
pub fn read(kit: &Kit, lab: Lab) -> Result<Rubric> {
    let facts = kit.facts(lab)?;
    let partial = facts.tasks.iter().map(|(id, task)| (id.clone(), task.partial)).collect();
    let tasks = facts.tasks.into_iter().map(|(id, task)| (id, task.points)).collect();
    let (complexity, scaling, speed) = (facts.complexity, facts.scaling, facts.speed);
    let has_loops = !facts.races.is_empty();
    let rubric = Rubric { tasks, partial, complexity, scaling, speed, has_loops };
    let file = format!("solutions/lab{lab}/lab.toml");
    ensure!(!rubric.tasks.is_empty(), "{file} names no task: lab {lab} cannot be graded");
    let points = rubric.tasks.values().copied();
    for points in points.chain(rubric.measures().map(|measure| measure.points)) {
        let some = points.is_finite() && points >= 0.0;
        ensure!(some, "{file}: {points} points cannot be given");
    }
    for (task, share) in &rubric.partial {
        let some = (0.0..=1.0).contains(share);
        ensure!(some, "{file}: partial: task {task} cannot have a share of {share}");
    }
    Ok(rubric)
}

/// The rubrics of all labs.
///
/// # Errors
/// One cannot be read.
pub fn all(kit: &Kit) -> Result<BTreeMap<Lab, Rubric>> {
    kit.solutions()?.into_iter().map(|lab| Ok((lab, read(kit, lab)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::{Rubric, all, read};
    use crate::answers::RegionId;
    use crate::kit::Kit;

    #[test]
    fn tasks_are_worth_a_hundred_points() {
        let kit = Kit::find().unwrap();
        for (lab, rubric) in all(&kit).unwrap() {
            assert_eq!(rubric.warning(lab), None);
            for task in rubric.tasks.keys() {
                let id: RegionId = task.parse().unwrap();
                assert_eq!(id.task.lab, lab, "{task}");
            }
            let facts = kit.facts(lab).unwrap();
            assert!(facts.races.iter().all(|race| rubric.tasks.contains_key(&race.task)));
            let variants = facts.variants;
            for timed in rubric.measures() {
                let known = variants.iter().any(|variant| variant.name == timed.variant);
                assert!(known && timed.points > 0.0, "lab {lab} has no variant {}", timed.variant);
            }
        }
    }

    /// The rubric of a lab 3 with these points for 3.1.
    fn with(points: &str) -> anyhow::Result<Rubric> {
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
    fn points_are_not_taken_away() {
        for points in ["-5", "nan", "inf"] {
            let error = with(points).unwrap_err().to_string();
            assert!(error.contains("cannot be given"), "{points}: {error}");
        }
    }
}
