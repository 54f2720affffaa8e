//! Questions about runs that must agree in every bit.

use common::soft::{Scene, Simulation};
use oracle::{Ask, Random, States, difference};

use super::RunsOnRanks;
use crate::{Rank, on_each};

impl RunsOnRanks {
    /// Asks whether several runs of each scene have the same bits after every one of `steps` steps.
    /// The runs are a first run, a second run, a run that is read only at its end, and a run of
    /// each of `others`.
    pub fn same_bits(&self, ask: &mut impl Ask, all: &[Scene], steps: usize, others: &[Self]) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            for scene in all {
                let found = self.repeated(rank, scene, steps, others);
                if rank.is_root() {
                    let count = scene.len();
                    let question = format!(
                        "{}, {count} particles, {steps} steps: x y vx vy of each particle (1) after each step of a \
                         first run, (2) after each step of a second run, (3) after the last step of a run whose state \
                         is read only once{}",
                        self.name(rank),
                        others
                            .iter()
                            .map(|other| format!("; {}", other.name(rank)))
                            .collect::<String>()
                    );
                    ask.judge(
                        &question,
                        || found,
                        |found| equal_runs(found, count, steps, others.len()),
                    );
                }
            }
        });
    }

    /// Returns the states of all runs of a scene.
    fn repeated(&self, rank: &Rank<'_>, scene: &Scene, steps: usize, others: &[Self]) -> Vec<f64> {
        let states = |engine: &mut dyn Simulation| States::of_run(engine, scene, steps, 0);
        rank.call("some runs", |world| {
            self.begin(world);
            let mut runs = vec![
                states(&mut *self.engine()),
                states(&mut *self.engine()),
                States::after_a_run(&mut *self.engine(), scene, steps),
            ];
            runs.extend(others.iter().map(|other| states(&mut *other.engine())));
            runs.into_iter().flat_map(States::numbers).collect()
        })
    }
}

/// Checks that the runs in `numbers` have the bits of the first run. The last `others` runs belong
/// to other programs.
fn equal_runs(
    mut numbers: &[f64],
    particles: usize,
    steps: usize,
    others: usize,
) -> Result<(), String> {
    let first = States::split(&mut numbers, particles, steps)?;
    let second = States::split(&mut numbers, particles, steps)?;
    same_states(&first, &second, "a second run")?;
    let end = States::split(&mut numbers, particles, 1)?;
    if let Some(words) = difference(&end.state(0), &first.state(steps - 1)) {
        return Err(format!("a run whose state is read only once has different bits: {words}"));
    }
    for _ in 0..others {
        let other = States::split(&mut numbers, particles, steps)?;
        same_states(&first, &other, "another variant or number of threads")?;
    }
    Ok(())
}

/// Checks that each state of a run has the bits of the first run's state.
fn same_states(first: &States, other: &States, whose: &str) -> Result<(), String> {
    for step in 0..first.count() {
        if let Some(words) = difference(&other.state(step), &first.state(step)) {
            return Err(format!("step {}: {whose} has different bits: {words}", step + 1));
        }
    }
    Ok(())
}
