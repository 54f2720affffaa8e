//! A variant at one value of the varied quantity.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::clock::{Ratio, Span};
use crate::cs3210::{Printed, hard_discs};
use crate::experiment::Timing;
use crate::over::Varied;
use crate::published::HARD_STEPS;
use crate::scene::Scene;

#[derive(Serialize)]
pub(super) struct Cell {
    #[serde(flatten)]
    pub(super) timing: Timing,
    #[serde(skip)]
    pub(super) at: f64,
    /// The value, under the name of the quantity, if the timing does not contain it.
    #[serde(flatten)]
    value: Option<BTreeMap<String, f64>>,
    pub(super) variant: String,
    pub(super) ms_per_step: Span,
    pub(super) pair_tests_per_step: Option<f64>,
    pub(super) report_ms_per_step: Option<Printed>,
    /// Ratio to the first variant at the same value; `None` for the first variant.
    #[serde(skip)]
    pub(super) ratio: Option<Ratio>,
}

/// Makes a cell for each variant at each value, with its ratio to the first variant.
pub(super) fn cells(varied: &Varied, timings: &[Timing]) -> Vec<Cell> {
    let mut cells = Vec::new();
    for row in timings.chunk_by(|a, b| varied.of(&a.job) == varied.of(&b.job)) {
        for (at, timing) in row.iter().enumerate() {
            let ratio = (at > 0).then(|| timing.ms().over(row[0].ms()));
            cells.push(Cell::new(varied, timing, ratio));
        }
    }
    cells
}

impl Cell {
    fn new(varied: &Varied, timing: &Timing, ratio: Option<Ratio>) -> Self {
        let at = varied.of(&timing.job);
        let program = &timing.job.program;
        Self {
            at,
            value: (!varied.is_workers()).then(|| BTreeMap::from([(varied.to_string(), at)])),
            variant: program.variant.clone().unwrap_or_else(|| program.package()),
            ms_per_step: timing.ms(),
            pair_tests_per_step: timing.per_step("pair tests"),
            report_ms_per_step: report(varied, at, timing),
            ratio,
            timing: timing.clone(),
        }
    }

    /// Returns the milliseconds that kernels take in a step, by the device's clock. `None` if the
    /// device has no clock.
    pub(super) fn kernels(&self) -> Option<f64> {
        Some(1e3 * self.timing.per_step("kernel time [s]")?)
    }

    /// Returns the milliseconds of a step for recording commands, copying and waiting, outside
    /// kernels.
    ///
    /// For soft discs, this is all time outside kernels. For hard discs, the host's computations
    /// are not included.
    pub(super) fn way_and_waiting(&self) -> Option<f64> {
        let kernels = self.kernels()?;
        match self.timing.job.program.is_hard() {
            true => Some(1e3 * self.timing.per_step("transfer time [s]")?),
            false => Some((self.ms_per_step.min - kernels).max(0.0)),
        }
    }

    /// Returns the report's milliseconds of a step; `None` if its program crashed.
    pub(super) fn report_ms(&self) -> Option<f64> {
        match self.report_ms_per_step? {
            Printed::Seconds(ms) => Some(ms),
            Printed::Crashes => None,
        }
    }
}

/// Finds the CS3210 report's number for the same program and scene on the report's machine, in ms
/// per step.
fn report(varied: &Varied, value: f64, timing: &Timing) -> Option<Printed> {
    let Scene::Hard { n, side, radius, speeds: None, blob: None } = timing.job.scene else {
        return None;
    };
    if varied.is_workgroup() {
        return None;
    }
    let program = &timing.job.program;
    let workers = varied.is_workers().then_some(value as usize);
    let variant = program.variant.as_deref()?;
    let report = hard_discs(program.workers, variant, (n, side, radius), workers)?;
    Some(report.scaled(1e3 / HARD_STEPS))
}
