//! The results of a program, and the verdict on each measured number (a figure). The figure passes,
//! is a limit of the method, or shows a mistake.

use anyhow::Result;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

use super::engine::{Lab, RunScene};
use super::inputs::{self, Input};
use super::method::Method;
use super::observed::{Met, Observed};
use super::trials::{Column, Trial};

#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Cell {
    pub(super) trial: &'static str,
    pub(super) column: &'static str,
    pub(super) steps: u64,
    /// The figure; `None` if nothing was measured.
    pub(super) figure: Option<f64>,
    #[serde(flatten)]
    pub(super) verdict: Verdict,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "verdict", content = "why", rename_all = "lowercase")]
pub(super) enum Verdict {
    Passes,
    /// The figure is as bad as the method allows, and no worse. The text is the section that
    /// explains the limit.
    Limit(&'static str),
    /// The reason why the program cannot do this.
    Unable(&'static str),
    Fails(String),
}

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

/// The cells of a trial, and the results of head-on pairs.
pub(super) struct Judged {
    pub(super) cells: Vec<Cell>,
    pub(super) met: Vec<Met>,
}

/// Runs a trial with `run`, which claims to use `method`, and judges it.
pub(super) fn judge(method: Method, trial: &Trial, run: &RunScene) -> Judged {
    let observed = match observe(method, trial, run) {
        Ok(observed) => observed,
        Err(verdict) => {
            let cells = trial.columns.iter().map(|c| Cell::new(trial, c, None, verdict.clone()));
            return Judged { cells: cells.collect(), met: Vec::new() };
        }
    };
    let mut cells = Vec::new();
    for (column, figure) in trial.columns.iter().zip(observed.figures(trial)) {
        let verdict = match (&observed.wrong, column.section) {
            (Some(why), _) => Verdict::Fails(why.clone()),
            (None, _) if figure.abs() <= column.good => Verdict::Passes,
            (None, Some(section)) if figure.is_finite() => Verdict::Limit(section),
            (None, _) => Verdict::Fails(format!("{} is {figure:.1e}", column.head)),
        };
        cells.push(Cell::new(trial, column, Some(figure), verdict));
    }
    Judged { cells, met: observed.met }
}

/// Runs all scenes of a trial. If nothing can be measured, the error is the verdict.
fn observe(method: Method, trial: &Trial, run: &RunScene) -> Result<Observed, Verdict> {
    let mut observed = Observed::default();
    for scene in &trial.scenes {
        let frames = match run(scene) {
            Ok(Some(frames)) => frames,
            Ok(None) => return Err(Verdict::Unable("its step is built in")),
            Err(why) => return Err(Verdict::Fails(format!("{why:#}"))),
        };
        // There must be a frame for every observed step, the first and the last among them.
        if frames.len() as u64 != (trial.steps - 1) / trial.every + 1 {
            return Err(Verdict::Fails(format!("it showed {} states", frames.len())));
        }
        observed.add(method, trial, scene, frames).map_err(Verdict::Fails)?;
    }
    Ok(observed)
}

impl Cell {
    fn new(trial: &Trial, column: &Column, figure: Option<f64>, verdict: Verdict) -> Self {
        Self { trial: trial.name, column: column.head, steps: trial.steps, figure, verdict }
    }
}

impl Row {
    /// Runs all trials and bad inputs with a program.
    pub(super) fn of(lab: &Lab, trials: &[Trial]) -> Result<Self> {
        let mut cells = Vec::new();
        let mut met = Vec::new();
        for trial in trials {
            let judged = judge(lab.method(), trial, &|scene| lab.run(scene, trial));
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
