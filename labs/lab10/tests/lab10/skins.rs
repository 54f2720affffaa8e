//! Questions about the skin of a list, task 10.3.

use std::f64::consts::PI;

use common::soft::CUTOFF;
use lab10::{best_skin, expired};
use neighbour_list_core::{LISTED, REBUILD, TESTED};
use oracle::{Ask, Random, truth};

/// Asks about displacements of half a skin, and as close to it as possible.
pub(crate) fn expiry(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..100 {
        let skin = random.magnitude(1e-9, 1e3);
        let half = 0.5 * skin;
        let drawn = half * random.around_one();
        for moved in [half, half.next_up(), half.next_down(), drawn, 0.0, 2.0 * skin] {
            let question = format!(
                "skin {skin:e}, displacement {moved:e}, in units of length: 1 if the list has expired, 0 if not"
            );
            let found = || vec![truth(expired(moved, skin))];
            ask.exact(&question, found, || vec![truth(moved > half)]);
        }
    }
    let question = "no list was built yet, so the displacement is infinite: 1 if the list has expired, 0 if not";
    ask.exact(question, || vec![truth(expired(f64::INFINITY, 0.0))], || vec![1.0]);
}

/// Asks for the best skin at any density and any displacement, including zero.
pub(crate) fn skins(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..100 {
        let density = if case < 99 { random.magnitude(1.0, 1e7) } else { 0.0 };
        let displacement = if case < 98 { random.magnitude(1e-4, 10.0) * CUTOFF } else { 0.0 };
        let question = format!(
            "{density:.1} particles per unit area, which move {:.4} cutoffs in a step: cheapest skin, in cutoffs",
            displacement / CUTOFF
        );
        let found = || vec![best_skin(density, displacement) / CUTOFF];
        ask.judge(&question, found, |found| Cost { density, displacement }.is_least(found));
    }
}

/// Cost of a step per particle.
struct Cost {
    density: f64,
    displacement: f64,
}

impl Cost {
    /// Returns the cost in nanoseconds for a skin in cutoffs.
    fn of(&self, skin: f64) -> f64 {
        let reach = CUTOFF + skin * CUTOFF;
        let listed = 0.5 * PI * reach * reach * self.density;
        let tested = 0.5 * 9.0 * reach * reach * self.density;
        let rebuilds = (2.0 * self.displacement / (skin * CUTOFF)).min(1.0);
        rebuilds * (REBUILD + TESTED * tested) + LISTED * listed
    }

    fn is_least(&self, found: &[f64]) -> Result<(), String> {
        let least = (2..=60)
            .map(|k| f64::from(k) * 0.05)
            .fold(0.05, |best, skin| if self.of(skin) < self.of(best) { skin } else { best });
        let &[skin] = found else { return Err("the answer is not complete".into()) };
        // The costs of two skins may differ only by rounding.
        let as_good = (self.of(skin) / self.of(least) - 1.0).abs() < 1e-9;
        if as_good || (skin - least).abs() < 1e-9 {
            return Ok(());
        }
        Err(format!(
            "     found: {skin:.4}, with which a step costs {:.4} ns for each particle\n  expected: {least:.4}, with \
             which a step costs {:.4} ns for each particle",
            self.of(skin),
            self.of(least)
        ))
    }
}
