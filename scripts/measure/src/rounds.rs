//! Timing jobs side by side.
//!
//! A machine's speed drifts with its clock, its temperature and its neighbours. So jobs take
//! turns: each round runs every job once, and a bad minute hurts all of them. Every other round
//! goes backwards, so that no job always follows the same one. The yardstick takes part.

use std::collections::BTreeMap;

use anyhow::Result;
use lab_kit::machine::cores;
use lab_kit::progress::progress;
use lab_kit::table::three_digits;
use serde::Serialize;
use serde_json::{Value, json};

use super::clock::Times;
use super::job::{Job, Outcome, Runner};
use oracle::yardstick;

/// What all rounds together say about one job.
#[derive(Clone, Debug)]
pub struct Measured {
    /// What ran.
    pub job: Job,
    /// Its times.
    pub times: Times,
    /// What the shortest run counted.
    pub counters: BTreeMap<String, f64>,
}

/// Nanoseconds per particle of the streaming bound.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Bound {
    /// Particles.
    pub n: usize,
    /// Threads.
    pub threads: usize,
    /// The shortest take.
    pub nanoseconds: f64,
}

/// What all rounds together say.
pub struct Rounds {
    /// In the order of the jobs.
    pub measured: Vec<Measured>,
    /// By ascending n, one thread and all.
    pub bounds: Vec<Bound>,
}

/// Runs all jobs `rounds` times, at least once.
pub fn measure(runner: &Runner, jobs: &[Job], rounds: usize) -> Result<Rounds> {
    let rounds = rounds.max(1);
    let bar = progress((rounds * jobs.len()) as u64);
    let mut outcomes: Vec<Vec<Outcome>> = vec![Vec::new(); jobs.len()];
    let mut bounds = bounds_of(jobs);
    for round in 0..rounds {
        let mut order: Vec<usize> = (0..jobs.len()).collect();
        if round % 2 == 1 {
            order.reverse();
        }
        for at in order {
            bar.set_message(format!("{} n={}", jobs[at].program, jobs[at].scene.n()));
            outcomes[at].push(runner.run(&jobs[at])?);
            bar.inc(1);
        }
        for bound in &mut bounds {
            let take = yardstick::nanoseconds(bound.n, bound.threads);
            bound.nanoseconds = bound.nanoseconds.min(take);
        }
    }
    bar.finish_and_clear();
    let measured = jobs.iter().zip(outcomes).filter_map(|(job, outcomes)| summed_up(job, outcomes));
    Ok(Rounds { measured: measured.collect(), bounds })
}

fn summed_up(job: &Job, outcomes: Vec<Outcome>) -> Option<Measured> {
    let times = Times::of(outcomes.iter().map(|o| o.seconds).collect())?;
    let best = outcomes.into_iter().min_by(|a, b| a.seconds.total_cmp(&b.seconds))?;
    Some(Measured { job: job.clone(), times, counters: best.counters })
}

/// A bound to be measured for each n, on one thread and on all.
fn bounds_of(jobs: &[Job]) -> Vec<Bound> {
    let mut sizes: Vec<usize> = jobs.iter().map(|job| job.scene.n()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut threads = vec![1, cores()];
    threads.dedup();
    let bound = |n, threads| Bound { n, threads, nanoseconds: f64::INFINITY };
    sizes.into_iter().flat_map(|n| threads.iter().map(move |&t| bound(n, t))).collect()
}

impl Rounds {
    /// The streaming bound at `n`: one thread's, or all threads' if `all`.
    pub fn bound(&self, n: usize, all: bool) -> f64 {
        let mut of_n = self.bounds.iter().filter(|bound| bound.n == n);
        let bound = if all { of_n.next_back() } else { of_n.next() };
        bound.map_or(f64::NAN, |bound| bound.nanoseconds)
    }

    /// The streaming bounds as lines to stand below a table.
    pub fn bounds_in_words(&self) -> String {
        let mut text = String::from("To read and write x, y, vx, vy of a particle takes at least");
        for Bound { n, threads, nanoseconds } in &self.bounds {
            let threads =
                if *threads == 1 { "one thread".into() } else { format!("{threads} threads") };
            text += &format!("\n  {} ns on {threads} at n = {n}", three_digits(*nanoseconds));
        }
        text
    }
}

impl Measured {
    /// Seconds as nanoseconds per particle and step.
    pub fn nanoseconds(&self, seconds: f64) -> f64 {
        seconds * 1e9 / (self.job.scene.n() as f64 * self.job.steps as f64)
    }

    /// Everything about it, for a record.
    pub fn as_json(&self) -> Value {
        json!({
            "program": self.job.program.to_string(), "scene": self.job.scene,
            "steps": self.job.steps, "ranks": self.job.ranks(), "threads": self.job.threads(),
            "seconds": self.times, "counters": self.counters,
            "nanoseconds_per_particle_and_step": {
                "min": self.nanoseconds(self.times.min()),
                "median": self.nanoseconds(self.times.median()),
            },
        })
    }
}
