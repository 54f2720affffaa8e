//! What a lab's tasks and measures are worth: `tests/rubric.toml`.

use std::collections::BTreeMap;
use std::fs;

use anyhow::{Context, Result};
use serde::Deserialize;

use crate::kit::{Kit, Lab};

/// What a lab is worth.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rubric {
    /// Points by task, such as `1.3`.
    pub(crate) tasks: BTreeMap<String, f64>,
    /// How the time grows with the number of particles; none if that is not graded.
    pub(crate) complexity: Option<Timed>,
    /// What more workers bring.
    pub(crate) scaling: Option<Timed>,
    /// How long it takes beside the solution.
    pub(crate) speed: Option<Timed>,
}

/// A measure of one program of a lab.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Timed {
    /// Points for the full grade.
    pub(crate) points: f64,
    /// Which program.
    pub(crate) variant: String,
    /// The number of particles, or the greatest one.
    pub(crate) n: usize,
}

impl Rubric {
    /// Whether there is anything to time.
    pub(crate) fn times_anything(&self) -> bool {
        self.complexity.is_some() || self.scaling.is_some() || self.speed.is_some()
    }
}

/// The rubric of a lab.
///
/// # Errors
/// The file cannot be read, or the lab is not in it.
pub(crate) fn read(kit: &Kit, lab: Lab) -> Result<Rubric> {
    all(kit)?.remove(&lab).with_context(|| {
        format!("tests/rubric.toml says nothing about lab {lab}: it cannot be graded")
    })
}

/// The rubrics of all labs that can be graded.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn all(kit: &Kit) -> Result<BTreeMap<Lab, Rubric>> {
    let text = fs::read_to_string(kit.path("tests/rubric.toml"))
        .context("cannot read tests/rubric.toml")?;
    let labs: BTreeMap<String, Rubric> = toml::from_str(&text).context("tests/rubric.toml")?;
    let numbered = labs.into_iter().map(|(lab, rubric)| {
        let lab = lab.parse().map_err(anyhow::Error::msg).context("tests/rubric.toml")?;
        Ok((lab, rubric))
    });
    numbered.collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::all;
    use crate::kit::Kit;
    use crate::marks::RegionId;

    #[test]
    fn tasks_are_worth_a_hundred_points() {
        let kit = Kit::at(Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap());
        for (lab, rubric) in all(&kit).unwrap() {
            let sum: f64 = rubric.tasks.values().sum();
            assert_eq!(sum, 100.0, "lab {lab}");
            for task in rubric.tasks.keys() {
                let id: RegionId = task.parse().unwrap();
                assert_eq!(id.task.lab, lab, "{task}");
            }
            for timed in [&rubric.complexity, &rubric.scaling, &rubric.speed].into_iter().flatten()
            {
                let source = crate::kit::files_below(&kit.solution(lab).join("src")).unwrap();
                let name = format!("\"{}\"", timed.variant);
                let known = source.iter().any(|path| {
                    std::fs::read_to_string(path).is_ok_and(|text| text.contains(&name))
                });
                assert!(known && timed.points > 0.0, "lab {lab} has no variant {name}");
            }
        }
    }
}
