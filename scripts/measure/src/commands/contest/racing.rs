//! The runs of the contest: races on random scenes, a second run, a long run, and a counted run.

use anyhow::Result;
use common::soft::CUTOFF;
use lab_kit::machine::on_all_cores;
use lab_kit::program::Program;
use oracle::contest::{Kind, STEPS};

use super::entry::Entry;
use super::ranking::ACCURATE;
use super::trial::{Drawn, End, Track, by};
use crate::cachegrind::{By, Caches, Profile};
use crate::commands::count::per;
use crate::commands::precision::reference::rms;
use crate::experiment::{one_by_one, turns};
use crate::job::Job;
use crate::runner::Runner;
use crate::scene;

/// Error below which differences do not count: a ten-millionth of a cutoff. This error is added to
/// all errors.
const LEAST: f64 = 1e-7 * CUTOFF;

/// Greatest distance (rms) between the ends of two runs, as a share of the official step's error.
const ROUNDING: f64 = 0.01;

/// Greatest growth of memory between a short run and a long run, in bytes.
const GROWTH: u64 = 4 << 20;
/// Number of steps of the short run.
const SHORT: u64 = 100;
/// Number of steps of the long run.
const LONG: u64 = 3000;

/// Settings that all runs share.
pub struct Contest {
    /// Engine whose time is 1.
    pub reference: Program,
    /// Number of threads that an entry may use.
    pub threads: usize,
    /// Divisor of the numbers of particles.
    pub shrink: usize,
    /// Seed of the first round's scenes.
    pub seed: u32,
}

impl Contest {
    /// Generates the random scenes of all rounds and computes their exact final states.
    ///
    /// # Errors
    /// If the exact motion cannot be computed.
    pub fn scenes(&self, rounds: u32) -> Result<Vec<Drawn>> {
        eprintln!("computing the exact motion of {} scenes", 5 * rounds);
        let kinds = (0..rounds).flat_map(|round| Kind::ALL.map(|kind| (kind, self.seed + round)));
        let kinds: Vec<(Kind, u32)> = kinds.collect();
        let drawn = on_all_cores(&kinds, |(kind, seed)| Drawn::new(*kind, self.shrink, *seed));
        drawn.into_iter().collect()
    }

    fn job(&self, program: &Program, drawn: &Drawn) -> Job {
        let scene = scene::Scene::Given(drawn.scene.clone());
        Job { workers: self.threads, ..Job::new(program.clone(), scene) }
    }

    /// Measures entries on all scenes, and then checks each entry in further runs.
    ///
    /// # Errors
    /// If the reference fails, or a program cannot be run at all.
    pub fn measure(
        &self,
        track: &Track<'_>,
        scenes: &[Drawn],
        entries: &mut [Entry],
    ) -> Result<()> {
        for (turn, drawn) in scenes.iter().enumerate() {
            self.race(track, drawn, turn, entries)?;
        }
        entries.iter_mut().for_each(Entry::summarise);
        entries.iter_mut().try_for_each(|entry| self.repeat(track, &scenes[0], entry))
    }

    /// Runs the reference and all entries on a scene in turn.
    fn race(
        &self,
        track: &Track<'_>,
        drawn: &Drawn,
        turn: usize,
        entries: &mut [Entry],
    ) -> Result<()> {
        let run = |program: &Program| drawn.run(track, self.job(program, drawn));
        let before = run(&self.reference)?.map_err(anyhow::Error::msg)?;
        let mut seconds = before.seconds;
        for at in turns(entries.len(), turn) {
            let entry = &mut entries[at];
            if entry.gave_up(drawn.kind) {
                continue;
            }
            match run(&entry.program)? {
                Ok(end) => {
                    // The reference runs before and after each entry, and the shorter of its two
                    // runs counts.
                    let after = run(&self.reference)?.map_err(anyhow::Error::msg)?.seconds;
                    let beside = seconds.min(after);
                    seconds = after;
                    let error = (end.error + LEAST) / (before.error + LEAST);
                    entry.add(drawn.kind, end.seconds / beside, error);
                }
                Err(why) => entry.fault(drawn, &why),
            }
        }
        Ok(())
    }

    /// Runs the first scene again, and then for more steps.
    ///
    /// This detects two faults: the repeated run ends in a state that differs by more than
    /// rounding, or the memory grows with the number of steps.
    fn repeat(&self, track: &Track<'_>, drawn: &Drawn, entry: &mut Entry) -> Result<()> {
        if !entry.faults.is_empty() {
            return Ok(());
        }
        let mut ends = Vec::new();
        let own = self.job(&entry.program, drawn);
        for job in [self.job(&self.reference, drawn), own.clone(), own] {
            match drawn.run(track, job)? {
                Ok(end) => ends.push(end),
                Err(why) => entry.fault(drawn, &why),
            }
        }
        if let [official, a, b] = &ends[..] {
            let apart = rms(&a.state, &b.state);
            if apart > ROUNDING * official.error {
                entry.fault(drawn, &format!("two runs end {apart:.1e} apart (rms)"));
            }
        }
        let small = Drawn::new(Kind::Crowd, 4, self.seed)?;
        let mut held = Vec::new();
        for steps in [SHORT, LONG] {
            let job = Job { steps, ..self.job(&entry.program, &small) };
            match track(&small, &job)? {
                Ok(output) => held.extend(output.resident),
                Err(why) => entry.fault(&small, &format!("{steps} steps: {why}")),
            }
        }
        if let [short, long] = held[..]
            && long > short + GROWTH
        {
            let grown = (long - short) >> 20;
            entry.fault(
                &small,
                &format!("the memory grows by {grown} MiB in {} steps", LONG - SHORT),
            );
        }
        Ok(())
    }

    /// Counts the instructions of each ranked entry in a whole run, if valgrind is installed.
    ///
    /// The run includes loading, and its scene is new to the entry. So work in `load` is counted, and results of an
    /// earlier run cannot be used again. An entry that is wrong in this run has no count.
    pub(super) fn count(
        &self,
        runner: &mut Runner,
        caches: Caches,
        rounds: u32,
        entries: &mut [Entry],
    ) -> Result<()> {
        let tool = match caches.tool(runner.folder()) {
            Ok(tool) => tool,
            Err(why) => {
                println!("Instructions are not counted: {why}");
                return Ok(());
            }
        };
        let drawn = Drawn::new(Kind::Official, self.shrink, self.seed + rounds)?;
        let official = drawn.run(&by(runner), self.job(&self.reference, &drawn))?;
        let official = official.map_err(anyhow::Error::msg)?.error;
        runner.under(tool);
        let counted = one_by_one(
            entries,
            |entry| format!("count {}", entry.program),
            |entry| {
                if !entry.faults.is_empty() {
                    return Ok(None);
                }
                let job = self.job(&entry.program, &drawn);
                let end = drawn.run(&by(runner), job.clone())?;
                // A run that was stopped at its limit leaves no readable counts.
                let profile = Profile::take(runner.folder(), By::Function).ok();
                let is_right = |end: End| end.error + LEAST <= ACCURATE * (official + LEAST);
                let steps = Job { steps: STEPS, ..job };
                let profile = profile.filter(|_| end.is_ok_and(is_right));
                Ok(profile.map(|profile| per(&steps, profile.total())[0]))
            },
        )?;
        for (entry, counted) in entries.iter_mut().zip(counted) {
            entry.instructions = counted;
        }
        runner.under(Vec::new());
        Ok(())
    }
}
