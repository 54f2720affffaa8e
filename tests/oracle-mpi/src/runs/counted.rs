//! Questions about the counters of a run: messages, steps per list, cuts.

use common::soft::Scene;
use oracle::Ask;

use super::RunsOnRanks;

impl RunsOnRanks {
    /// Asks for the counters with these `names` after `steps` steps of a scene. `verdict` receives
    /// the number of ranks and the counters, NaN for a counter that the variant does not have.
    pub fn counters(
        &self,
        ask: &mut impl Ask,
        scene: &Scene,
        steps: usize,
        names: &[&str],
        verdict: impl Fn(usize, &[f64]) -> Result<(), String>,
    ) {
        let question = format!("{} particles, {steps} steps: {}", scene.len(), names.join("; "));
        self.answered(
            ask,
            &question,
            |engine| {
                engine.load(scene);
                engine.run(steps as u64);
                let counters = engine.counters();
                let named = |name: &&str| counters.iter().find(|(counter, _)| counter == name);
                names.iter().map(|name| named(name).map_or(f64::NAN, |counter| counter.1)).collect()
            },
            verdict,
        );
    }
}
