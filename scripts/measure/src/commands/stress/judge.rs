//! The verdict on a measured number (a figure). The figure passes, is a limit of the method, or
//! shows a mistake.

use serde::Serialize;

use super::engine::{Answer, Asked};
use super::method::Method;
use super::observed::{Met, Observed};
use super::trials::{Column, Trial};

/// A cell of the table.
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

/// The cells of a trial, and the results of head-on pairs.
pub(super) struct Judged {
    pub(super) cells: Vec<Cell>,
    pub(super) met: Vec<Met>,
}

/// Runs a trial with `run`, which claims to use `method`, and judges it.
pub(super) fn judge(method: Method, run: impl Fn(&Asked) -> Answer, trial: &Trial) -> Judged {
    let observed = match observe(method, run, trial) {
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
fn observe(
    method: Method,
    run: impl Fn(&Asked) -> Answer,
    trial: &Trial,
) -> Result<Observed, Verdict> {
    let mut observed = Observed::default();
    for scene in &trial.scenes {
        let &Trial { steps, every, stretch, .. } = trial;
        let frames = match run(&Asked { scene, steps, every, stretch }) {
            Ok(Some(frames)) => frames,
            Ok(None) => return Err(Verdict::Unable("its step is built in")),
            Err(why) => return Err(Verdict::Fails(format!("{why:#}"))),
        };
        // There must be a frame for every observed step, the first and the last among them.
        if frames.len() as u64 != (steps - 1) / every + 1 {
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
