//! Questions about the width and the depth of ghosts, and about the number of steps for which they
//! last.

use common::soft::CUTOFF;
use lab13::{ACROSS, GHOST, RENEWAL, STEP, WAIT, best_depth, best_steps, deep_width, ghost_width};
use oracle::{Ask, Near, Random, rounded};
use strips::{Outlook, Scenery};

/// Asks for the width of ghosts, or the depth if `deep`, for few and many steps, at rest, slow and
/// fast.
pub(crate) fn widths(random: &mut Random, ask: &mut impl Ask, deep: bool) {
    for steps in random.sizes(70_000).into_iter().filter(|&steps| steps > 0) {
        for fastest in [0.0, random.magnitude(1e-15, 1e9), CUTOFF * random.magnitude(1e-3, 1e3)] {
            let question = format!(
                "the fastest particle moves {fastest:?} in each of {steps} steps: how {} the ghosts must be for these \
                 steps",
                if deep { "deep" } else { "wide" }
            );
            let width = if deep { deep_width } else { ghost_width };
            ask.near(
                &question,
                || vec![width(fastest, steps as u32)],
                || {
                    let cutoffs = if deep { steps as f64 } else { 1.0 };
                    let right = cutoffs * CUTOFF + 2.0 * (steps - 1) as f64 * fastest;
                    vec![Near { right, scale: right }]
                },
            );
        }
    }
}

/// A height at which the cutoff is negligible and all costs are exact.
const HUGE: f64 = (1_u64 << 60) as f64;

/// Asks for the number of steps for which ghosts last.
pub(crate) fn cheapest_steps(random: &mut Random, ask: &mut impl Ask) {
    let even = Scenery { fastest: HUGE, density: 0.0, height: HUGE, most: 3 };
    ask.exact(
        &format!(
            "{even:?}, where one step and two steps cost the same: number of steps for which ghosts are chosen"
        ),
        || vec![f64::from(best_steps(even))],
        || vec![1.0],
    );
    for _ in 0..1000 {
        let scenery = Scenery {
            fastest: CUTOFF * random.magnitude(1e-6, 1e3),
            density: random.magnitude(1e-4, 1e2) / (CUTOFF * CUTOFF),
            height: CUTOFF * random.magnitude(1e-1, 1e6),
            most: 1 + random.size(300) as u32,
        };
        let question = format!("{scenery:?}: number of steps for which ghosts are chosen");
        let found = || vec![f64::from(best_steps(scenery))];
        ask.judge(&question, found, |found| {
            cheapest(found, scenery.most, |steps| cost_of_list(scenery, steps))
        });
    }
}

/// Returns the cost of a step per particle if ghosts last for `steps` steps.
fn cost_of_list(Scenery { fastest, density, height, .. }: Scenery, steps: u32) -> f64 {
    let width = CUTOFF + 2.0 * f64::from(steps - 1) * fastest;
    let pairs = 2.0 * 2.0 / 3.0 * density * width * width * width / height;
    RENEWAL / f64::from(steps) + GHOST * 2.0 * width / height + ACROSS * pairs
}

/// Asks for the number of steps without messages.
pub(crate) fn cheapest_epochs(random: &mut Random, ask: &mut impl Ask) {
    let even = Outlook { fastest: HUGE / 4.0, height: HUGE, particles: 1000.0, most: 3 };
    ask.exact(
        &format!("{even:?}, where epochs of one step and of two steps cost the same: number of steps in an epoch"),
        || vec![f64::from(best_depth(even))],
        || vec![1.0],
    );
    for _ in 0..1000 {
        let outlook = Outlook {
            fastest: CUTOFF * random.magnitude(1e-6, 1e3),
            height: CUTOFF * random.magnitude(1e-1, 1e6),
            particles: random.magnitude(1.0, 1e8),
            most: 1 + random.size(300) as u32,
        };
        let question = format!("{outlook:?}: number of steps in an epoch");
        let found = || vec![f64::from(best_depth(outlook))];
        ask.judge(&question, found, |found| {
            cheapest(found, outlook.most, |steps| cost_of_epoch(outlook, steps))
        });
    }
}

/// Returns the cost of a step per particle in epochs of `steps` steps.
fn cost_of_epoch(Outlook { fastest, height, particles, .. }: Outlook, steps: u32) -> f64 {
    let m = f64::from(steps);
    let depth = m * CUTOFF + 2.0 * (m - 1.0) * fastest;
    let particle = STEP + RENEWAL / m;
    particle + 2.0 * depth / height * particle + WAIT / (particles * m)
}

/// Checks that no number from 1 to `most` is cheaper than the answer.
fn cheapest(found: &[f64], most: u32, cost: impl Fn(u32) -> f64) -> Result<(), String> {
    let &[found] = found else { return Err("the answer is not one number".into()) };
    if !(1..=most).any(|steps| f64::from(steps) == found) {
        return Err(format!("{found} is not a number of steps from 1 to {most}"));
    }
    let mut best = 1;
    for steps in 2..=most {
        if cost(steps) < cost(best) {
            best = steps;
        }
    }
    let least = cost(best);
    let price = cost(found as u32);
    if rounded(price, least, least) == least {
        return Ok(());
    }
    Err(format!(
        "with {found} steps, a step costs {price:.6} ns for each particle. With {best} steps, it costs only \
         {least:.6} ns"
    ))
}
