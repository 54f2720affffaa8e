//! Statistics of a run's pairs, which cost nothing in a run without statistics.

/// The statistics of one step, over ordered pairs (i, j) with 0 < r² ≤ cutoff².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// The least distance of a pair, in cutoffs; 1 if there was no pair.
    pub dmin: f64,
    /// The sum of the distances, in cutoffs.
    pub davg: f64,
    /// The number of pairs. Each unordered pair counts twice.
    pub navg: u64,
    /// The number of ordered pairs that were tested, near or far: the work of the step.
    ///
    /// A program that tests a pair once and uses the result for both particles counts 1.
    pub pair_tests: u64,
}

impl Default for Statistics {
    fn default() -> Self {
        Self { dmin: 1.0, davg: 0.0, navg: 0, pair_tests: 0 }
    }
}

/// An observer of the forces of a step.
///
/// The observer is a type parameter of every engine. With [`NoStatistics`] all calls are empty and
/// the compiler removes them, so a run without statistics does not pay for them.
pub trait Observer: Default + Clone + Send + Sync + 'static {
    /// Records that `pairs` ordered pairs were tested.
    fn tested(&mut self, pairs: u64);

    /// Records an ordered pair at squared distance `r2` ≤ cutoff².
    ///
    /// The pair of a particle with itself, at distance 0, may be recorded too, and is ignored.
    fn seen(&mut self, r2: f64);

    /// Adds the records of `other` for the same step.
    fn merge(&mut self, other: &Self);

    /// Returns the statistics since this observer was made, or `None` if it collects no statistics.
    fn statistics(&self) -> Option<Statistics>;
}

/// The observer that records nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoStatistics;

impl Observer for NoStatistics {
    #[inline(always)]
    fn tested(&mut self, _pairs: u64) {}
    #[inline(always)]
    fn seen(&mut self, _r2: f64) {}
    #[inline(always)]
    fn merge(&mut self, _other: &Self) {}
    fn statistics(&self) -> Option<Statistics> {
        None
    }
}

/// Makes a boxed engine with the observer `$tally` or, without statistics, [`NoStatistics`].
///
/// `$engine` is compiled for both observers, and refers to either as `$observer`.
#[macro_export]
macro_rules! observed {
    ($config:expr, $tally:ty, |$observer:ident| $engine:expr) => {
        if $config.statistics {
            type $observer = $tally;
            Box::new($engine)
        } else {
            type $observer = $crate::soft::NoStatistics;
            Box::new($engine)
        }
    };
}

/// Returns the statistics of a step that several observers have recorded, merged in their order.
pub fn merged<'a, O: Observer>(observers: impl IntoIterator<Item = &'a O>) -> Option<Statistics> {
    let mut all = O::default();
    observers.into_iter().for_each(|seen| all.merge(seen));
    all.statistics()
}

/// The statistics of a run, computed from the statistics of its steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averages {
    /// The least distance of any pair in any step, in cutoffs.
    pub absmin: f64,
    /// The mean distance in a step, averaged over the steps that had a pair, in cutoffs.
    pub absavg: f64,
    /// Number of neighbours per particle and step.
    pub neighbours: f64,
    /// Number of tested ordered pairs per particle and step.
    pub pair_tests: f64,
}

impl Averages {
    /// Averages over the `steps` of a run of `n` particles. Returns `None` for a run without steps.
    pub fn of(n: usize, steps: &[Statistics]) -> Option<Self> {
        if steps.is_empty() {
            return None;
        }
        let means: Vec<f64> =
            steps.iter().filter(|s| s.navg > 0).map(|s| s.davg / s.navg as f64).collect();
        let particle_steps = n as f64 * steps.len() as f64;
        Some(Self {
            absmin: steps.iter().map(|s| s.dmin).fold(1.0, f64::min),
            absavg: means.iter().sum::<f64>() / means.len().max(1) as f64,
            neighbours: steps.iter().map(|s| s.navg as f64).sum::<f64>() / particle_steps,
            pair_tests: steps.iter().map(|s| s.pair_tests as f64).sum::<f64>() / particle_steps,
        })
    }
}
