//! Task 13.7: ghosts several cutoffs deep.

use common::soft::CUTOFF;
use strips::Outlook;

/// Returns the ghost depth, a length, that lets a rank take `steps` steps without a message.
///
/// `steps` is at least 1. In a step, no particle of any rank moves further than `fastest`, a
/// length. If the rank knows all particles of other ranks within the ghost depth of its strip, its
/// own particles must be right in all of these steps.
///
/// The rank receives whole particles once, before the first step. It accelerates and moves them
/// like its own particles, and receives no message until the last step is over.
///
/// The outermost ghosts have neighbours that the rank does not know, so the first step already
/// moves them wrongly. In the next step, they exert wrong forces on their neighbours. With each
/// computation of forces, the error advances by a cutoff. As in
/// [`ghost_width`](crate::ghost_width), both particles of a pair move between two computations. The
/// last forces must still be right on a particle at the very edge of the strip.
///
/// Book: chapter 13, *Without a word*.
pub fn deep_width(fastest: f64, steps: u32) -> f64 {
    // task 13.7: how deep ghosts must be
    let moves = 2.0 * f64::from(steps - 1) * fastest;
    f64::from(steps) * CUTOFF + moves
    // end 13.7
}

/// Returns the number of steps that an epoch should have.
///
/// A rank receives no message during an epoch. Of 1, 2, … `most` steps, choose the number that
/// makes a step cheapest. Of equally cheap numbers, choose the least.
///
/// All costs are for each particle of the rank. On both sides of a strip of height H there are
/// ghosts of depth D, so there are 2 · D / H ghosts for each particle. A ghost costs as much as a
/// particle: [`STEP`] in each step, and [`RENEWAL`](crate::RENEWAL) once in each epoch, for the new
/// list. The messages of an epoch cost a rank [`WAIT`], whatever its number of particles.
///
/// Book: chapter 13, *Without a word*.
pub fn best_depth(outlook: Outlook) -> u32 {
    // task 13.7b: for how many steps there should be no message
    let Outlook { fastest, height, particles, most } = outlook;
    let cost = |steps: u32| {
        let all = 1.0 + 2.0 * deep_width(fastest, steps) / height;
        let epoch = all * crate::RENEWAL + WAIT / particles;
        all * STEP + epoch / f64::from(steps)
    };
    let mut best = 1;
    for steps in 2..=most {
        if cost(steps) < cost(best) {
            best = steps;
        }
    }
    best
    // end 13.7b
}

/// The cost of a particle in a step (its forces and its move), in nanoseconds on the book's
/// machine.
pub const STEP: f64 = 10.0;
/// The assumed cost of a rank's messages in an epoch, in nanoseconds. A rank spends most of this
/// time waiting for the slowest rank.
pub const WAIT: f64 = 20_000.0;
