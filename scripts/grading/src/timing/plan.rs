//! Plans the runs that the measures of a lab need.

use crate::record::{Run, Whose};
use lab_kit::machine::doubled_up_to;
use lab_kit::{Facts, Workers};
use oracle::Random;

/// Name of the best serial program, which is a program of lab 2.
pub(crate) const SERIAL: &str = "sorted";

/// Returns the seven sizes of a complexity measure, each twice the previous size, up to `most`.
pub(crate) fn sizes(most: usize) -> Vec<usize> {
    (0..7).rev().map(|halvings| (most >> halvings).max(1)).collect()
}

/// Returns the numbers of workers: 2, 4, … and all cores. A single worker shows no scaling.
pub(crate) fn workers(cores: usize) -> Vec<usize> {
    doubled_up_to(cores).into_iter().filter(|p| *p > 1).collect()
}

/// Returns a rubric with up to a tenth more particles in each measure, in steps of a hundred.
///
/// The seed of a record determines the number, so a program cannot be written for one fixed number.
pub(crate) fn drawn(rubric: &Facts, seed: u64) -> Facts {
    let mut rubric = rubric.clone();
    let more = Random::new(seed).between(1.0, 1.1);
    let measures = [&mut rubric.complexity, &mut rubric.scaling, &mut rubric.speed];
    for timed in measures.into_iter().flatten() {
        timed.n = ((timed.n as f64 * more) as usize / 100 * 100).max(timed.n);
    }
    rubric
}

/// Returns all runs of a lab's measures, each once.
///
/// Every size has a run of a trusted program, whose result is right by definition. It also has a
/// run without steps, which shows the time for making and sending a scene. That time depends on the
/// number of ranks, so each number of ranks has its own run without steps.
pub(crate) fn plan(rubric: &Facts, seed: u64, cores: usize) -> Vec<Run> {
    let rubric = drawn(rubric, seed);
    let steps = 40 + seed % 21;
    let mut runs: Vec<Run> = Vec::new();
    let mut add = |whose, variant: &str, n, workers, steps| {
        let run = Run::planned(whose, variant, n, workers, steps);
        if !runs.contains(&run) {
            runs.push(run);
        }
    };
    if let Some(timed) = &rubric.complexity {
        for n in sizes(timed.n) {
            add(Whose::Solution, &timed.variant, n, 1, steps);
            add(Whose::Own, &timed.variant, n, 1, steps);
        }
    }
    if let Some(timed) = &rubric.scaling {
        let each = (timed.n / cores).max(1);
        for p in workers(cores) {
            add(Whose::Serial, SERIAL, each, 1, steps);
            for n in [timed.n, each * p] {
                add(Whose::Serial, SERIAL, n, 1, steps);
                // If the solution's times are noisy too, the machine causes the noise.
                add(Whose::Solution, &timed.variant, n, p, steps);
                add(Whose::Own, &timed.variant, n, p, steps);
            }
        }
    }
    if let Some(timed) = &rubric.speed {
        add(Whose::Solution, &timed.variant, timed.n, cores, steps);
        add(Whose::Own, &timed.variant, timed.n, cores, steps);
    }
    let mut idle: Vec<Run> = Vec::new();
    for run in runs.iter().filter(|run| run.whose != Whose::Own) {
        if idle.iter().all(|other| other.n != run.n) {
            idle.push(Run { steps: 0, workers: 1, ..run.clone() });
        }
    }
    let ranks = rubric.workers == Workers::Ranks;
    for own in runs.iter().filter(|run| ranks && run.whose == Whose::Own) {
        let run = Run { whose: Whose::Solution, steps: 0, ..own.clone() };
        if !idle.contains(&run) {
            idle.push(run);
        }
    }
    runs.extend(idle);
    runs
}

#[cfg(test)]
mod tests {
    use super::{plan, sizes, workers};
    use crate::record::{Run, Whose};
    use lab_kit::facts::Timed;
    use lab_kit::{Facts, Workers};

    #[test]
    fn sizes_and_workers_double() {
        assert_eq!(sizes(64_000), [1000, 2000, 4000, 8000, 16_000, 32_000, 64_000]);
        assert!(workers(1).is_empty());
        assert_eq!(workers(2), [2]);
        assert_eq!(workers(6), [2, 4, 6]);
    }

    #[test]
    fn every_size_has_what_it_is_compared_with() {
        let timed = Some(Timed { points: 1.0, variant: "x".into(), n: 1000 });
        let scaling = timed.clone();
        let rubric = Facts { complexity: timed.clone(), scaling, speed: timed, ..Facts::default() };
        let jobs = plan(&rubric, 8, 3);
        let (own, trusted): (Vec<&Run>, Vec<&Run>) =
            jobs.iter().partition(|job| job.whose == Whose::Own);
        for own in &own {
            for steps in [own.steps, 0] {
                assert!(trusted.iter().any(|j| (j.n, j.steps) == (own.n, steps)), "{own:?}");
            }
        }
        let count = jobs.len();
        let own = own.len();
        // Complexity needs 7 runs, one for each size. Scaling needs 4 runs: for both numbers of
        // workers, 2 and 3, one run on the full scene and one run on a scene that grows with them.
        assert!(own == 7 + 4 && count < 40, "{own} of {count}");
    }

    #[test]
    fn every_number_of_ranks_has_a_run_without_steps() {
        let timed = Some(Timed { points: 1.0, variant: "x".into(), n: 1000 });
        let rubric = Facts { scaling: timed, workers: Workers::Ranks, ..Facts::default() };
        let jobs = plan(&rubric, 7, 4);
        for own in jobs.iter().filter(|job| job.whose == Whose::Own) {
            let mut same = jobs.iter().filter(|j| (j.n, j.workers) == (own.n, own.workers));
            let idle = same.find(|j| j.steps == 0 && j.variant == "x");
            assert_eq!(idle.map(|idle| idle.whose), Some(Whose::Solution), "{own:?}");
        }
    }
}
