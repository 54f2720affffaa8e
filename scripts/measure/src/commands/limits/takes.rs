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
type Stretch = [f64; 2];

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
        Ok([until, runner.run(&self.job(workers, self.after + steps))?.seconds])
    }
}

impl Take {
    /// Returns the least times of two rounds.
    pub(super) fn least(self, other: Self) -> Self {
        Self {
            alone: least(self.alone, other.alone),
            on_all: self.on_all.zip(other.on_all).map(|(a, b)| least(a, b)),
            streaming: self.streaming.min(other.streaming),
        }
    }

    /// Returns the seconds of the counted steps.
    pub(super) fn seconds(self) -> f64 {
        self.alone[1] - self.alone[0]
    }

    /// Returns the seconds of the counted steps on all cores; `None` if workers do not share them.
    pub(super) fn seconds_on_all(self) -> Option<f64> {
        self.on_all.map(|[until, in_all]| in_all - until)
    }
}

fn least(a: Stretch, b: Stretch) -> Stretch {
    [a[0].min(b[0]), a[1].min(b[1])]
}
