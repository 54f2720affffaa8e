//! Statistics of a run's pairs, which cost nothing when nobody asks.

/// What one step saw, over ordered pairs (i, j) with 0 < r² ≤ cutoff².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// The least distance of a pair, in units of the cutoff; 1 if there was no pair.
    pub dmin: f64,
    /// The sum of the distances, in units of the cutoff.
    pub davg: f64,
    /// Their number. Each unordered pair counts twice.
    pub navg: u64,
    /// How many ordered pairs were looked at, near or far: the work of the step. A program that
    /// looks at a pair once and serves both particles counts 1.
    pub pair_tests: u64,
}

impl Default for Statistics {
    fn default() -> Self {
        Self { dmin: 1.0, davg: 0.0, navg: 0, pair_tests: 0 }
    }
}

/// Looks on while a step computes its forces.
///
/// Every engine takes its observer as a type parameter. With [`NoStatistics`] each call is empty and
/// the compiler removes it, so that a run without statistics pays nothing for them.
pub trait Observer: Default + Clone + Send + Sync + 'static {
    /// `pairs` ordered pairs were looked at.
    fn tested(&mut self, pairs: u64);

    /// An ordered pair at squared distance `r2` ≤ cutoff² was found. The particle itself, at 0,
    /// may be among them and does not count.
    fn seen(&mut self, r2: f64);

    /// Adds what `other` saw of the same step.
    fn merge(&mut self, other: &Self);

    /// The statistics since this observer was made; none if it collects none.
    fn statistics(&self) -> Option<Statistics>;
}

/// The observer that does not look.
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

/// A boxed engine: with the observer `$tally` where the run collects statistics, else with [`NoStatistics`]. `$engine`
/// is compiled for both, and calls either one `$observer`.
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

/// The statistics of a step that several observers have seen, merged in their order.
pub fn merged<'a, O: Observer>(observers: impl IntoIterator<Item = &'a O>) -> Option<Statistics> {
    let mut all = O::default();
    observers.into_iter().for_each(|seen| all.merge(seen));
    all.statistics()
}

/// The statistics of a run, from those of its steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averages {
    /// The least distance of any pair in any step, in units of the cutoff.
    pub absmin: f64,
    /// The mean over steps that had a pair of their mean distance, in units of the cutoff.
    pub absavg: f64,
    /// Neighbours per particle and step.
    pub neighbours: f64,
    /// Ordered pairs looked at per particle and step.
    pub pair_tests: f64,
}

impl Averages {
    /// Averages over the `steps` of a run of `n` particles; none for a run without steps.
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
