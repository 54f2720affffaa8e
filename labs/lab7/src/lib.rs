#![doc = include_str!("../README.md")]

mod append;
mod blocks;
mod candidate;
mod cells;
mod choice;
mod loops;
mod pairs;
mod resolve;
mod schedule;
mod step;
mod swept;
mod walls;
mod windows;

use std::cmp::Ordering;
use std::ops::Range;

use common::hard::{Disc, Simulation};
use common::{Variant, bitwise};
use hard_discs::programs::{self, CHUNK, DISC_CHUNK, WHOLE_BLOCKS, WINDOWS, dynamic};
use hard_discs::{
    BroadPhase, Choice, Collect, Collisions, Engine, Entry, Find, LockedCount, ParallelLoops,
    Schedule, SharedCount, Slots, Span, Step, Survey, Team, Which,
};

pub use append::{append_atomic, append_locked};
pub use blocks::{block_of, blocks_around, look_around};
pub use candidate::order;
pub use cells::partners;
pub use choice::{take, take_in_order};
pub use hard_discs::{Candidate, Hit, Square, Window};
pub use loops::{inner, nested, outer};
pub use pairs::{pair_hit, pair_time};
pub use resolve::{bounce, collide, impulse, stop_at_wall, travel};
pub use schedule::{fixed_part, next_part, parallel_for};
pub use step::{collide_in, step};
pub use swept::span;
pub use walls::wall_hit;
pub use windows::choose_windows;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    bitwise("sequential", "all pairs, one thread", &[], programs::all_pairs::<Lab7>),
    bitwise("outer-static", "outer loop in fixed parts (the report's p1)", &[], |config| {
        programs::loops::<Lab7>(config, Which::Outer, Schedule::Static)
    }),
    bitwise("outer-dynamic", "outer loop from a queue (the report's p1d)", &[CHUNK], |config| {
        programs::loops::<Lab7>(config, Which::Outer, dynamic(config))
    }),
    bitwise("inner-static", "inner loop in fixed parts (the report's p2)", &[], |config| {
        programs::loops::<Lab7>(config, Which::Inner, Schedule::Static)
    }),
    bitwise("inner-dynamic", "inner loop from a queue (the report's p2d)", &[CHUNK], |config| {
        programs::loops::<Lab7>(config, Which::Inner, dynamic(config))
    }),
    bitwise(
        "nested-mixed",
        "outer loop from a queue, inner ones in fixed parts by fresh teams (the report's p3)",
        &[CHUNK],
        |config| programs::loops::<Lab7>(config, Which::Nested, dynamic(config)),
    ),
    bitwise(
        "shared-locked",
        "as outer-dynamic; candidates in one array, counted under a lock (as the report has it)",
        &[CHUNK],
        |config| programs::collected::<Lab7>(config, Collect::Locked, Choice::Sort),
    ),
    bitwise("shared-atomic", "the same, counted by fetch_add", &[CHUNK], |config| {
        programs::collected::<Lab7>(config, Collect::Atomic, Choice::Sort)
    }),
    bitwise(
        "merge-sort",
        "as outer-dynamic; lists are sorted in parallel and merged",
        &[CHUNK],
        |config| programs::collected::<Lab7>(config, Collect::Own, Choice::Merge),
    ),
    bitwise(
        "grid",
        "the report's grid of 4 x 4, 2 x 2 and 1 blocks, one thread",
        &[],
        programs::grid::<Lab7>,
    ),
    bitwise(
        "grid-parallel",
        "the same, discs or blocks from a queue",
        &[DISC_CHUNK, WHOLE_BLOCKS],
        programs::grid_parallel::<Lab7>,
    ),
    bitwise("cells", "sorted occupied cells, the step in one window", &[], programs::cells::<Lab7>),
    bitwise(
        "planned",
        "the same, windows of time as the scene needs",
        &[WINDOWS],
        programs::planned::<Lab7>,
    ),
];

/// Appends to `list` the candidates of disc `a` with the discs in `partners`.
///
/// These are the pairs that collide in this step. All `partners` have higher numbers than `a`.
pub fn look_along(
    discs: &[Disc],
    a: usize,
    partners: Range<usize>,
    radius: f64,
    list: &mut Vec<Candidate>,
) {
    hard_discs::look_along::<Lab7>(discs, a, partners, radius, list);
}

/// Carries out the collisions `taken`. `discs` are as they were at the start of the step.
pub fn resolve(taken: &[Candidate], discs: &mut [Disc], square: Square) {
    hard_discs::resolve::<Lab7>(taken, discs, square);
}

/// The functions of the tasks, under the names that the library calls.
pub struct Lab7;

impl Collisions for Lab7 {
    #[inline]
    fn wall_hit(a: u32, disc: &Disc, square: Square) -> Option<Candidate> {
        wall_hit(a, disc, square)
    }

    #[inline]
    fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate> {
        pair_hit(discs, a, b, radius)
    }

    #[inline]
    fn order(a: &Candidate, b: &Candidate) -> Ordering {
        order(a, b)
    }

    fn take_in_order(candidates: &mut [Candidate], free: &mut [bool], taken: &mut Vec<Candidate>) {
        take_in_order(candidates, free, taken);
    }

    #[inline]
    fn bounce(disc: &mut Disc, time: f64, hit: Hit, square: Square) {
        bounce(disc, time, hit, square);
    }

    #[inline]
    fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square) {
        collide(a, b, time, square);
    }
}

impl Step for Lab7 {
    fn step<F: Find>(engine: &mut Engine<Self, F>) {
        step(engine);
    }
}

impl ParallelLoops for Lab7 {
    fn parallel_for(
        n: usize,
        team: Team,
        schedule: Schedule,
        body: impl Fn(usize, Range<usize>) + Sync,
    ) {
        parallel_for(n, team, schedule, body);
    }

    fn all_pairs(
        which: Which,
        n: usize,
        team: Team,
        schedule: Schedule,
        look: impl Fn(usize, usize, Range<usize>) + Sync,
    ) {
        match which {
            Which::Outer => outer(n, team, schedule, look),
            Which::Inner => inner(n, team, schedule, look),
            Which::Nested => nested(n, team, schedule, look),
        }
    }

    #[inline]
    fn append_locked(list: &Slots, count: &LockedCount, candidate: Candidate) {
        append_locked(list, count, candidate);
    }

    #[inline]
    fn append_atomic(list: &Slots, count: &SharedCount, candidate: Candidate) {
        append_atomic(list, count, candidate);
    }
}

impl BroadPhase for Lab7 {
    #[inline]
    fn span(x: f64, v: f64, window: Window, reach: f64) -> Span {
        span(x, v, window, reach)
    }

    fn block_of(x: Span, y: Span, side: f64) -> usize {
        block_of(x, y, side)
    }

    fn look_around(blocks: &[Vec<u32>], block: usize, index: usize, look: impl FnMut(&[u32])) {
        look_around(blocks, block, index, look);
    }

    #[inline(always)]
    fn partners(entries: &[Entry], k: usize) -> Range<usize> {
        partners(entries, k)
    }

    fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize {
        choose_windows(survey, square, crowding)
    }
}
