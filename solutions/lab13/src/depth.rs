//! Task 13.7: ghosts several cutoffs deep.

use common::soft::CUTOFF;
use strips::Outlook;

/// How far from its strip a rank must know the particles of other ranks, so that it can move them
/// itself for `steps` steps, at least 1, and its own particles are right in all of them. A length,
/// like `fastest`.
///
/// The rank gets whole particles, once, before the first of these steps. It accelerates and moves them
/// like its own, and gets no message until the last step is over. No particle of any rank goes
/// further than `fastest` in a step.
///
/// The outermost of these ghosts lack neighbours that the rank does not know, so the first step
/// already moves them wrongly. In the next step they exert wrong forces on their own neighbours. The
/// error comes nearer by a cutoff with each computation of forces; and, as in
/// [`ghost_width`](crate::ghost_width), both of a pair move between two of them. The last forces must
/// still be right on a particle at the very edge of the strip.
///
/// Book: chapter 13, *Without a word*.
pub fn deep_width(fastest: f64, steps: u32) -> f64 {
    // task 13.7: how deep ghosts must be
    let moves = 2.0 * f64::from(steps - 1) * fastest;
    f64::from(steps) * CUTOFF + moves
    // end 13.7
}

/// How many steps an epoch should have, that is, how many a rank takes without a message: of 1, 2, …
/// `most` the number that makes a step cheapest; of equal ones the fewest.
///
/// All costs are counted for each own particle. With ghosts of depth D on both sides of a strip of
/// height H there are 2 D / H ghosts for each own particle, and each of them costs what an own
/// particle costs: [`STEP`] in each step and [`RENEWAL`](crate::RENEWAL) in each epoch, whose list is rebuilt. The
/// messages of an epoch cost a rank [`WAIT`], however many particles it has.
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

/// The forces on a particle and its move, in a step, in nanoseconds on the machine of the book.
pub const STEP: f64 = 10.0;
/// The messages of an epoch, for a rank, in nanoseconds, as assumed: mostly it waits for the slowest.
pub const WAIT: f64 = 20_000.0;
