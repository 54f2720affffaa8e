//! How exact LAMMPS's force of a pair is.

use anyhow::{Context, Result};
use common::soft::{CUTOFF, MASS};
use oracle::acceleration_of_pair;
use serde::Serialize;

use super::install::Installed;
use super::setup::Style;
use lab_measure::runner::Runner;

/// The largest error of a pair's force, relative to the exact force at its distance.
#[derive(Serialize)]
pub(super) struct PairError {
    pub(super) style: Style,
    pub(super) distances: usize,
    /// From half a cutoff on: nearer than that hardly a pair of the official scene comes.
    pub(super) beyond_half_a_cutoff: f64,
    /// From a hundredth of a cutoff on.
    pub(super) largest: f64,
}

/// The errors of each style.
pub(super) fn errors(
    lammps: &Installed,
    runner: &Runner,
    styles: &[Style],
) -> Result<Vec<PairError>> {
    let of = |&style: &Style| {
        let mut command = style.usual().command(lammps, 1);
        let said = runner.words(command.arg("forces"), "LAMMPS")?;
        let error = |line: &str| {
            let (r, force) = line.split_once(' ')?;
            let (r, force): (f64, f64) = (r.parse().ok()?, force.parse().ok()?);
            let exact = -MASS * acceleration_of_pair(r, 0.0).x;
            Some((r, (force / exact - 1.0).abs()))
        };
        let errors: Option<Vec<(f64, f64)>> = said.lines().map(error).collect();
        let errors = errors.context("LAMMPS said no forces")?;
        let largest = |from: f64| {
            errors.iter().filter(|(r, _)| *r >= from).map(|(_, error)| *error).fold(0.0, f64::max)
        };
        Ok(PairError {
            style,
            distances: errors.len(),
            beyond_half_a_cutoff: largest(0.5 * CUTOFF),
            largest: largest(0.0),
        })
    };
    styles.iter().map(of).collect()
}
