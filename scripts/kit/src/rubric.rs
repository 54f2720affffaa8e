//! What a lab's tasks and measures are worth: `tests/rubric.toml`.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use crate::files::read_text;
use crate::kit::Kit;
use crate::lab::Lab;

/// The tasks of a lab are worth so many points together.
const WHOLE: f64 = 100.0;

/// What a lab is worth.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rubric {
    /// Points by task, such as `1.3`.
    pub tasks: BTreeMap<String, f64>,
    /// What a task that is wrong can still earn, as a share of its points, 0 to 1: in proportion to the
    /// questions that were answered rightly. Nothing if nothing is said.
    #[serde(default)]
    pub partial: BTreeMap<String, f64>,
    /// How the time grows with the number of particles; none if that is not graded.
    pub complexity: Option<Timed>,
    /// What more workers bring.
    pub scaling: Option<Timed>,
    /// How long it takes beside the solution.
    pub speed: Option<Timed>,
}

/// A measure of one program of a lab.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Timed {
    /// Points for the full grade.
    pub points: f64,
    /// Which program.
    pub variant: String,
    /// The number of particles, or the greatest one.
    pub n: usize,
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
        ((sum - WHOLE).abs() > 1e-6).then(|| {
            format!(
                "warning: in tests/rubric.toml the tasks of lab {lab} add up to {sum}, not {WHOLE}"
            )
        })
    }
}

/// The rubric of a lab.
///
/// # Errors
/// The file cannot be read, or the lab is not in it.
pub fn read(kit: &Kit, lab: Lab) -> Result<Rubric> {
    all(kit)?.remove(&lab).with_context(|| {
        format!("tests/rubric.toml says nothing about lab {lab}: it cannot be graded")
    })
}

/// The rubrics of all labs that can be graded.
///
/// # Errors
/// The file cannot be read, or takes points away.
pub fn all(kit: &Kit) -> Result<BTreeMap<Lab, Rubric>> {
    parse(&read_text(&kit.path("tests/rubric.toml"))?).context("tests/rubric.toml")
}

fn parse(text: &str) -> Result<BTreeMap<Lab, Rubric>> {
    let labs: BTreeMap<String, Rubric> = basic_toml::from_str(text)?;
    let numbered = labs.into_iter().map(|(lab, rubric)| {
        let lab: Lab = lab.parse().map_err(anyhow::Error::msg)?;
        let points = rubric.tasks.values().copied();
        for points in points.chain(rubric.measures().map(|measure| measure.points)) {
            let some = points.is_finite() && points >= 0.0;
            ensure!(some, "lab {lab}: {points} points cannot be given");
        }
        for (task, share) in &rubric.partial {
            let some = (0.0..=1.0).contains(share) && rubric.tasks.contains_key(task);
            ensure!(some, "lab {lab}: partial: task {task} cannot have a share of {share}");
        }
        Ok((lab, rubric))
    });
    numbered.collect()
}

#[cfg(test)]
mod tests {
    use super::{all, parse};
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
            for timed in rubric.measures() {
                let source = crate::files::files_below(&kit.solution(lab).join("src")).unwrap();
                let name = format!("\"{}\"", timed.variant);
                let known = source.iter().any(|path| {
                    std::fs::read_to_string(path).is_ok_and(|text| text.contains(&name))
                });
                assert!(known && timed.points > 0.0, "lab {lab} has no variant {name}");
            }
        }
    }

    #[test]
    fn other_sums_are_pointed_out() {
        let warning = |points: &str| {
            let labs = parse(&format!("[lab3.tasks]\n\"3.1\" = {points}\n")).unwrap();
            labs.iter().find_map(|(lab, rubric)| rubric.warning(*lab))
        };
        assert_eq!(warning("60\n\"3.2\" = 40"), None);
        let said = warning("110").unwrap();
        assert!(said.contains("the tasks of lab 3 add up to 110, not 100"), "{said}");
    }

    #[test]
    fn a_share_is_a_part_of_a_task() {
        for (share, well) in
            [("\"3.1\" = 0.5", true), ("\"3.1\" = 2", false), ("\"3.9\" = 0.5", false)]
        {
            let text = format!("[lab3.tasks]\n\"3.1\" = 100\n[lab3.partial]\n{share}\n");
            assert_eq!(parse(&text).is_ok(), well, "{share}");
        }
    }

    #[test]
    fn points_are_not_taken_away() {
        for points in ["-5", "nan", "inf"] {
            let text = format!("[lab3.tasks]\n\"3.1\" = {points}\n");
            assert!(parse(&text).unwrap_err().to_string().contains("lab 3: "), "{points}");
        }
    }
}
