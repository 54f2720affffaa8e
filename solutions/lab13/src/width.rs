//! Task 13.1: how wide ghosts must be.

use common::soft::CUTOFF;
use strips::Scenery;

/// How far from its strip a rank must know the particles of other ranks, so that its ghosts last
/// for `steps` steps, at least 1. A length, like `fastest`.
///
/// Ghosts are chosen where particles stand, before the first of these steps; no particle of any
/// rank goes further than `fastest` in a step. A pair across the border must be known as soon as it
/// is within the cutoff. Both of a pair move. Forces are computed before a step moves particles, so
/// in the first step ghosts and particles stand where they were chosen.
///
/// Book: chapter 13, *How wide*.
pub fn ghost_width(fastest: f64, steps: u32) -> f64 {
    // task 13.1: how wide ghosts must be
    CUTOFF + 2.0 * f64::from(steps - 1) * fastest
    // end 13.1
}

/// For how many steps ghosts should be chosen: of 1, 2, … `most` steps the number that makes a step
/// cheapest; of equal ones the fewest.
///
/// All costs are counted for each particle of a strip of height H, with ghosts of width W on both of
/// its sides and `density` ρ. There are 2 W / H ghosts for each particle, and
/// 2 · ⅔ ρ W³ / H pairs across its borders that are at most W apart. Each ghost costs [`GHOST`] in
/// a step and each pair [`ACROSS`]. To rebuild lists costs [`RENEWAL`], once in these steps.
///
/// Book: chapter 13, *How wide*.
pub fn best_steps(scenery: Scenery) -> u32 {
    // task 13.1b: for how many steps ghosts should last
    let Scenery { fastest, density, height, most } = scenery;
    let cost = |steps: u32| {
        let width = ghost_width(fastest, steps);
        let pairs = 2.0 / 3.0 * density * width.powi(3);
        RENEWAL / f64::from(steps) + 2.0 / height * (GHOST * width + ACROSS * pairs)
    };
    let mut best = 1;
    for steps in 2..=most {
        if cost(steps) < cost(best) {
            best = steps;
        }
    }
    best
    // end 13.1b
}

/// New lists, for each particle, in nanoseconds on the machine of the book.
/// Costs decide nothing but speed, and they are constants, so that a run repeats.
pub const RENEWAL: f64 = 40.0;
/// A ghost that is sent, or received.
pub const GHOST: f64 = 5.0;
/// A look at a pair across the border in a step.
pub const ACROSS: f64 = 1.0;
