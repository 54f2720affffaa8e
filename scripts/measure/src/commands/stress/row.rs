//! The results of one program.

use anyhow::Result;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

use super::engine::Lab;
use super::inputs::{self, Input};
use super::judge::{Cell, Verdict, judge};
use super::observed::Met;
use super::trials::Trial;

/// The results of a program.
#[derive(Serialize)]
pub(super) struct Row {
    pub(super) program: Program,
    /// A cell for each column of each trial, in their order.
    pub(super) cells: Vec<Cell>,
    #[serde(rename = "head_on")]
    met: Vec<Met>,
    pub(super) inputs: Vec<Input>,
}

/// The part of a row that the chart needs.
#[derive(Deserialize)]
pub(crate) struct Pairs {
    pub(super) program: Program,
    #[serde(rename = "head_on")]
    pub(super) met: Vec<Met>,
}

impl Row {
    /// Runs all trials and bad inputs with a program.
    pub(super) fn of(lab: &Lab, trials: &[Trial]) -> Result<Self> {
        let mut cells = Vec::new();
        let mut met = Vec::new();
        for trial in trials {
            let judged = judge(lab.method(), |asked| lab.run(asked), trial);
            cells.extend(judged.cells);
            met.extend(judged.met);
        }
        let inputs = inputs::BAD.iter().map(|bad| bad.give(lab)).collect::<Result<_>>()?;
        Ok(Self { program: lab.program.clone(), cells, met, inputs })
    }

    /// Whether no cell fails and all bad inputs are refused.
    pub(super) fn holds(&self) -> bool {
        self.cells.iter().all(|cell| !matches!(cell.verdict, Verdict::Fails(_)))
            && self.inputs.iter().all(|input| input.refused)
    }
}
