//! Task 13.1: the width of ghosts.

use common::soft::CUTOFF;
use strips::Scenery;

/// Returns the ghost width, a length, that is enough for `steps` steps.
///
/// `steps` is at least 1. In a step, no particle of any rank moves further than `fastest`, a
/// length. A rank knows all particles of other ranks within the ghost width of its strip.
///
/// Ghosts are chosen by the positions of particles before the first step. A pair across the border
/// must be known as soon as it is within the cutoff. Both particles of a pair move. Forces are
/// computed before a step moves particles, so in the first step all particles are where they were
/// when ghosts were chosen.
///
/// Book: chapter 13, *How wide*.
pub fn ghost_width(fastest: f64, steps: u32) -> f64 {
    todo!("task 13.1: how wide ghosts must be")
}

/// Returns the number of steps that ghosts should last.
///
/// Of 1, 2, … `most` steps, choose the number that makes a step cheapest. Of equally cheap numbers,
/// choose the least.
///
/// All costs are for each particle of a strip of height H, with ghosts of width W on both sides and
/// a `density` of ρ. For each particle there are 2 · W / H ghosts. There are also
/// 2 · ⅔ · ρ · W³ / H pairs across the borders whose particles are at most W apart. In a step, each
/// ghost costs [`GHOST`] and each pair costs [`ACROSS`]. Rebuilding the lists costs [`RENEWAL`],
/// once in all of these steps.
///
/// Book: chapter 13, *How wide*.
pub fn best_steps(scenery: Scenery) -> u32 {
    todo!("task 13.1b: for how many steps ghosts should last")
}

/// The cost of new lists for each particle, in nanoseconds on the book's machine.
///
/// Costs affect only the speed. They are constants, so that every run computes the same results.
pub const RENEWAL: f64 = 40.0;
/// The cost of sending or receiving a ghost, in nanoseconds.
pub const GHOST: f64 = 5.0;
/// The cost of testing a pair across the border in a step, in nanoseconds.
pub const ACROSS: f64 = 1.0;
