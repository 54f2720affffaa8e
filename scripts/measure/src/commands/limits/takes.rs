//! Runs of the programs that were counted.

use anyhow::Result;
use lab_kit::machine;
use lab_machine::streaming;

use crate::commands::count;
use crate::job::Job;
use crate::runner::Runner;

/// A program whose events were counted after the first `after` steps.
pub(super) struct Counted {
    pub(super) row: count::Row,
    pub(super) after: u64,
    /// Whether more workers share the program's work.
    pub(super) shared: bool,
}

/// Seconds of a run until counting began, and of the whole run.
#[derive(Clone, Copy)]
struct Stretch {
    until: f64,
    in_all: f64,
}

/// The runs of a program in one round.
#[derive(Clone, Copy)]
pub(super) struct Take {
    alone: Stretch,
    /// The run with a worker for each core; `None` if workers do not share the work.
    on_all: Option<Stretch>,
    pub(super) streaming: f64,
}

impl Counted {
    pub(super) fn name(&self) -> String {
        self.row.job.program.to_string()
    }

    pub(super) fn n(&self) -> usize {
        self.row.job.scene.n()
    }

    pub(super) fn job(&self, workers: usize, steps: u64) -> Job {
        Job { steps, workers, ..self.row.job.clone() }
    }

    pub(super) fn take(&self, runner: &Runner, steps: u64) -> Result<Take> {
        let alone = self.stretch(runner, 1, steps)?;
        let on_all = self.shared.then(|| self.stretch(runner, machine::cores(), steps));
        let streaming = streaming::nanoseconds(self.n(), 1);
        Ok(Take { alone, on_all: on_all.transpose()?, streaming })
    }

    fn stretch(&self, runner: &Runner, workers: usize, steps: u64) -> Result<Stretch> {
        let until = runner.run(&self.job(workers, self.after))?.seconds;
        let in_all = runner.run(&self.job(workers, self.after + steps))?.seconds;
        Ok(Stretch { until, in_all })
    }
}

impl Stretch {
    fn least(self, other: Self) -> Self {
        Self { until: self.until.min(other.until), in_all: self.in_all.min(other.in_all) }
    }

    fn seconds(self) -> f64 {
        self.in_all - self.until
    }
}

impl Take {
    /// Returns the least times of two rounds.
    pub(super) fn least(self, other: Self) -> Self {
        Self {
            alone: self.alone.least(other.alone),
            on_all: self.on_all.zip(other.on_all).map(|(a, b)| a.least(b)),
            streaming: self.streaming.min(other.streaming),
        }
    }

    /// Returns the seconds of the counted steps.
    pub(super) fn seconds(self) -> f64 {
        self.alone.seconds()
    }

    /// Returns the seconds of the counted steps on all cores; `None` if workers do not share them.
    pub(super) fn seconds_on_all(self) -> Option<f64> {
        self.on_all.map(Stretch::seconds)
    }
}
