//! An entry: its times and errors on all kinds of scenes.

use std::collections::BTreeMap;

use lab_kit::program::Program;
use oracle::contest::Kind;
use serde::{Deserialize, Serialize};

use super::trial::Drawn;
use crate::clock::{Span, Times};

/// A program in the contest.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Entry {
    pub(super) program: Program,
    /// Name on the page of a class; `None` elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) alias: Option<String>,
    /// Rounds of each kind of scene, by its name.
    pub(super) kinds: BTreeMap<String, Vec<Round>>,
    /// Time for all kinds: the least and the median of the rounds' geometric means. `None` if a kind is missing.
    pub time: Option<Span>,
    /// Error for all kinds, computed like the time.
    pub error: Option<Span>,
    /// Instructions per particle and step of the official scene; `None` if they were not counted.
    pub(super) instructions: Option<f64>,
    /// Reasons why the entry is not ranked.
    pub faults: Vec<String>,
}

/// Time and error of a run.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct Round {
    /// Time as a multiple of the reference's time on the same scene.
    pub(super) time: f64,
    /// Error as a multiple of the official step's error on the same scene.
    pub(super) error: f64,
}

impl Entry {
    /// Makes the entry of a program that has not run yet.
    pub fn new(program: Program) -> Self {
        Self {
            program,
            alias: None,
            kinds: BTreeMap::new(),
            time: None,
            error: None,
            instructions: None,
            faults: Vec::new(),
        }
    }

    /// Returns the alias or the program's name.
    pub(super) fn name(&self) -> String {
        self.alias.clone().unwrap_or_else(|| self.program.to_string())
    }

    pub(super) fn add(&mut self, kind: Kind, time: f64, error: f64) {
        self.kinds.entry(kind.name().into()).or_default().push(Round { time, error });
    }

    /// Adds a fault and the scene that showed it.
    pub(super) fn fault(&mut self, drawn: &Drawn, why: &str) {
        self.faults.push(format!("{}, seed {}: {why}", drawn.kind.name(), drawn.seed));
    }

    /// Whether the entry had a fault on a scene of this kind. If so, the entry runs no further
    /// scenes of this kind.
    pub(super) fn gave_up(&self, kind: Kind) -> bool {
        self.faults.iter().any(|fault| fault.starts_with(kind.name()))
    }

    /// Returns the times on scenes of a kind; `None` if no run was correct.
    pub(super) fn times(&self, kind: Kind) -> Option<Times> {
        Times::of(self.kinds.get(kind.name())?.iter().map(|round| round.time).collect())
    }

    /// Returns the errors on scenes of a kind; `None` if no run was correct.
    pub(super) fn errors(&self, kind: Kind) -> Option<Times> {
        Times::of(self.kinds.get(kind.name())?.iter().map(|round| round.error).collect())
    }

    /// Computes the time and the error for all kinds.
    pub(super) fn summarise(&mut self) {
        self.time = self.overall(|round| round.time);
        self.error = self.overall(|round| round.error);
    }

    fn overall(&self, of: impl Fn(&Round) -> f64) -> Option<Span> {
        let rounds = Kind::ALL.map(|kind| self.kinds.get(kind.name()).map_or(0, Vec::len));
        let mut means = Vec::new();
        for round in 0..*rounds.iter().min()? {
            let logarithms: f64 = self.kinds.values().map(|all| of(&all[round]).ln()).sum();
            means.push((logarithms / self.kinds.len() as f64).exp());
        }
        Some(Times::of(means)?.span(1.0))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Makes an entry with these times and errors for every kind.
    pub(in super::super) fn entry(rounds: &[(f64, f64)]) -> Entry {
        let mut entry = Entry::new("solution2:sorted".parse().unwrap());
        for kind in Kind::ALL {
            rounds.iter().for_each(|&(time, error)| entry.add(kind, time, error));
        }
        entry.summarise();
        entry
    }

    #[test]
    fn the_whole_is_the_geometric_mean_of_the_kinds() {
        let mut entry = entry(&[(2.0, 1.0), (4.0, 1.0), (3.0, 1.0)]);
        let time = entry.time.unwrap();
        assert!((time.min - 2.0).abs() < 1e-12 && (time.median - 3.0).abs() < 1e-12, "{time:?}");
        entry.kinds.get_mut("crowd").unwrap().iter_mut().for_each(|round| round.error = 32.0);
        entry.summarise();
        assert!((entry.error.unwrap().median - 2.0).abs() < 1e-12);
        entry.kinds.remove("crowd");
        entry.summarise();
        assert!(entry.error.is_none());
    }
}
