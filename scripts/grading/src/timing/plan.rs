//! Which runs the measures of a lab need.

use std::collections::BTreeMap;

use crate::record::{Outcome, Run, Whose};
use lab_kit::rubric::Rubric;

/// Time steps of a run.
pub(crate) const STEPS: u64 = 50;

/// The best serial program: lab 2's.
pub(crate) const SERIAL: &str = "sorted";

/// One kind of run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Job {
    pub(crate) whose: Whose,
    pub(crate) variant: String,
    pub(crate) n: usize,
    pub(crate) workers: usize,
    pub(crate) steps: u64,
}

impl Job {
    /// Whether it is what was run.
    pub(crate) fn is_of(&self, run: &Run) -> bool {
        (self.whose, self.n, self.workers, self.steps) == (run.whose, run.n, run.workers, run.steps)
            && self.variant == run.variant
    }

    /// Without any take yet.
    pub(crate) fn run(&self) -> Run {
        Run {
            whose: self.whose,
            variant: self.variant.clone(),
            n: self.n,
            workers: self.workers,
            steps: self.steps,
            seconds: Vec::new(),
            processors: Some(0.0),
            outcome: Outcome::Timed,
            message: String::new(),
            counted: BTreeMap::new(),
        }
    }
}

/// The sizes of a complexity measure: doubled up to `most`, over a factor of 64.
pub(crate) fn sizes(most: usize) -> Vec<usize> {
    (0..7).rev().map(|halvings| (most >> halvings).max(1)).collect()
}

/// 2, 4, … and all cores: one worker does not scale.
pub(crate) fn workers(cores: usize) -> Vec<usize> {
    let doubled = std::iter::successors(Some(2), |p| Some(2 * p)).take_while(|p| *p < cores);
    doubled.chain((cores > 1).then_some(cores)).collect()
}

/// All runs of a lab's measures, each once. For every size there is a trusted one, which says what
/// is right, and one without any step, which says what making and sending a scene takes. With ranks
/// that also depends on how many bring their parts together, so each number of them has its own.
pub(crate) fn jobs(rubric: &Rubric, cores: usize, ranks: bool) -> Vec<Job> {
    let mut jobs: Vec<Job> = Vec::new();
    let mut add = |whose, variant: &str, n, workers, steps| {
        let job = Job { whose, variant: variant.to_owned(), n, workers, steps };
        if !jobs.contains(&job) {
            jobs.push(job);
        }
    };
    if let Some(timed) = &rubric.complexity {
        for n in sizes(timed.n) {
            add(Whose::Solution, &timed.variant, n, 1, STEPS);
            add(Whose::Own, &timed.variant, n, 1, STEPS);
        }
    }
    if let Some(timed) = &rubric.scaling {
        let each = (timed.n / cores).max(1);
        for p in workers(cores) {
            add(Whose::Serial, SERIAL, each, 1, STEPS);
            for n in [timed.n, each * p] {
                add(Whose::Serial, SERIAL, n, 1, STEPS);
                // Whose the noise is shows beside the solution's times.
                add(Whose::Solution, &timed.variant, n, p, STEPS);
                add(Whose::Own, &timed.variant, n, p, STEPS);
            }
        }
    }
    if let Some(timed) = &rubric.speed {
        add(Whose::Solution, &timed.variant, timed.n, cores, STEPS);
        add(Whose::Own, &timed.variant, timed.n, cores, STEPS);
    }
    let mut idle: Vec<Job> = Vec::new();
    for job in jobs.iter().filter(|job| job.whose != Whose::Own) {
        if idle.iter().all(|other| other.n != job.n) {
            idle.push(Job { steps: 0, workers: 1, ..job.clone() });
        }
    }
    for own in jobs.iter().filter(|job| ranks && job.whose == Whose::Own) {
        let job = Job { whose: Whose::Solution, steps: 0, ..own.clone() };
        if !idle.contains(&job) {
            idle.push(job);
        }
    }
    jobs.extend(idle);
    jobs
}

#[cfg(test)]
mod tests {
    use super::{jobs, sizes, workers};
    use crate::record::Whose;
    use lab_kit::rubric::{Rubric, Timed};

    #[test]
    fn sizes_and_workers_double() {
        assert_eq!(sizes(64_000), [1000, 2000, 4000, 8000, 16_000, 32_000, 64_000]);
        assert!(workers(1).is_empty());
        assert_eq!(workers(2), [2]);
        assert_eq!(workers(6), [2, 4, 6]);
    }

    #[test]
    fn every_size_has_what_it_is_compared_with() {
        let timed = || Some(Timed { points: 1.0, variant: "x".into(), n: 1000 });
        let rubric =
            Rubric { complexity: timed(), scaling: timed(), speed: timed(), ..Rubric::default() };
        let jobs = jobs(&rubric, 3, false);
        for own in jobs.iter().filter(|job| job.whose == Whose::Own) {
            let trusted = |steps| {
                jobs.iter().any(|j| j.whose != Whose::Own && j.n == own.n && j.steps == steps)
            };
            assert!(trusted(own.steps) && trusted(0), "{own:?}");
        }
        let (count, own) = (jobs.len(), jobs.iter().filter(|job| job.whose == Whose::Own).count());
        // 7 sizes; 2 and 3 workers on 1000 and on 333 each.
        assert!(own == 7 + 4 && count < 40, "{own} of {count}");
    }

    #[test]
    fn every_number_of_ranks_has_a_run_without_steps() {
        let timed = Some(Timed { points: 1.0, variant: "x".into(), n: 1000 });
        let rubric = Rubric { scaling: timed, ..Rubric::default() };
        let jobs = jobs(&rubric, 4, true);
        for own in jobs.iter().filter(|job| job.whose == Whose::Own) {
            let same = |j: &&super::Job| (j.n, j.workers) == (own.n, own.workers);
            let idle = jobs.iter().filter(same).find(|j| j.steps == 0 && j.variant == "x");
            assert_eq!(idle.map(|idle| idle.whose), Some(Whose::Solution), "{own:?}");
        }
    }
}
