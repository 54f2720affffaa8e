//! The engine's counters.

/// Counters since the scene was loaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Steps taken.
    pub steps: u64,
    /// Lists built.
    pub rebuilds: u64,
    /// Pairs tested, both in lists and while lists were built.
    pub tests: u64,
    /// Sum of the skins of all lists, in cutoffs.
    pub skins: f64,
    /// Inner lists built.
    pub inner_rebuilds: u64,
    /// Total number of outliers in all inner lists.
    pub outliers: u64,
}

impl Counts {
    /// Returns the counters with their names, some of them per step, for a run of `n` particles.
    pub(crate) fn shown(&self, n: usize) -> Vec<(&'static str, f64)> {
        let Counts { steps, rebuilds, tests, skins, inner_rebuilds, outliers } = *self;
        let particle_steps = n as f64 * steps as f64;
        vec![
            ("pair tests per particle and step", tests as f64 / particle_steps),
            ("particles touched per particle and step", 1.0),
            ("steps per rebuild", steps as f64 / rebuilds as f64),
            ("mean skin [cutoffs]", skins / rebuilds as f64),
            ("short lists per list", inner_rebuilds as f64 / rebuilds as f64),
            (
                "share that outruns the list",
                outliers as f64 / (n as f64 * inner_rebuilds.max(1) as f64),
            ),
        ]
    }
}
