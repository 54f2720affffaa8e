//! Lab 7, collisions: discs that fly straight until they hit a wall or each other.
//!
//! A step of hard discs is a search and a decision. The search looks for all collisions that could
//! happen in the step: the *candidates*. Disc by disc for walls, pair by pair for discs, it can be
//! done by many threads in any order. The decision goes through the candidates in order of time
//! and takes each whose discs have not collided yet in this step; it is serial, and short.
//!
//! The search has n (n − 1) / 2 pairs, nearly all of them far apart. This lab shares these out among
//! threads, in the ways that the CS3210 report tried: tasks 7.1 to 7.10. Its further tasks do not look
//! at them: they cut space into cells and the step into windows of time.
//!
//! | task | file | what |
//! |------|------|------|
//! | 7.1 | `walls.rs` | when a disc hits a wall |
//! | 7.2 | `pairs.rs` | when two discs touch |
//! | 7.3 | `candidate.rs` | which of two candidates comes first |
//! | 7.4 | `choice.rs` | which candidates happen |
//! | 7.5 | `resolve.rs` | a disc that would leave the square waits at the wall |
//! | 7.6 | `resolve.rs` | what a collision does to velocities and positions |
//! | 7.7 | `step.rs` | one step |
//! | 7.8 | `schedule.rs` | a loop shared out: fixed parts, a queue |
//! | 7.9 | `loops.rs` | which loop is shared out: outer, inner, both |
//! | 7.10 | `append.rs` | candidates of all workers in one array |
//!
//! Further tasks, which are worth no points unless your instructor says so:
//!
//! | task | file | what |
//! |------|------|------|
//! | 7.11 | `swept.rs` | the box that a disc sweeps |
//! | 7.12 | `blocks.rs` | the blocks of a grid of three levels |
//! | 7.13 | `cells.rs` | sorted occupied cells |
//! | 7.14 | `windows.rs` | how many windows of time |
//!
//! The rest is a library, `hard-discs`: threads and what they share, searches for pairs, the [`Engine`]
//! that a step works on. It calls the functions of this lab by the traits that [`Lab7`] implements below.
//!
//! All variants give the same bits, on any scene and with any number of threads: they find the same
//! candidates with the same function, and the decision does not depend on the order in which
//! they were found.

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
use common::{Config, Variant};
use hard_discs::programs::{self, Built, CHUNK, GRID_CHUNK, WINDOWS, dynamic, variant};
use hard_discs::{
    BroadPhase, Choice, Collect, Collisions, Engine, Entry, Find, LockedCount, ParallelLoops,
    Schedule, SharedCount, Slots, Span, Step, Survey, Team, Which,
};

pub use append::{append_atomic, append_locked};
pub use blocks::{block_of, blocks_around};
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
    variant("sequential", "all pairs, one thread", &[], programs::all_pairs::<Lab7>),
    variant("outer-static", "outer loop in fixed parts (the report's p1)", &[], |config| {
        loops(Which::Outer, Schedule::Static, config)
    }),
    variant("outer-dynamic", "outer loop from a queue (the report's p1d)", CHUNK, |config| {
        loops(Which::Outer, dynamic(config), config)
    }),
    variant("inner-static", "inner loop in fixed parts (the report's p2)", &[], |config| {
        loops(Which::Inner, Schedule::Static, config)
    }),
    variant("inner-dynamic", "inner loop from a queue (the report's p2d)", CHUNK, |config| {
        loops(Which::Inner, dynamic(config), config)
    }),
    variant(
        "nested-mixed",
        "outer loop from a queue, inner ones in fixed parts by fresh teams (the report's p3)",
        CHUNK,
        |config| loops(Which::Nested, dynamic(config), config),
    ),
    variant(
        "shared-locked",
        "as outer-dynamic; candidates in one array, counted under a lock (as the report has it)",
        CHUNK,
        |config| collected(Collect::Locked, Choice::Sort, config),
    ),
    variant("shared-atomic", "the same, counted by fetch_add", CHUNK, |config| {
        collected(Collect::Atomic, Choice::Sort, config)
    }),
    variant(
        "merge-sort",
        "as outer-dynamic; lists are sorted in parallel and merged",
        CHUNK,
        |config| collected(Collect::Own, Choice::Merge, config),
    ),
    variant(
        "grid",
        "the report's grid of 4 x 4, 2 x 2 and 1 blocks, one thread",
        &[],
        programs::grid::<Lab7>,
    ),
    variant(
        "grid-parallel",
        "the same, discs from a queue",
        GRID_CHUNK,
        programs::grid_parallel::<Lab7>,
    ),
    variant("cells", "sorted occupied cells, the step in one window", &[], programs::cells::<Lab7>),
    variant(
        "planned",
        "the same, windows of time as the scene needs",
        WINDOWS,
        programs::planned::<Lab7>,
    ),
];

fn loops(which: Which, schedule: Schedule, config: &Config) -> Built {
    programs::loops::<Lab7>(which, schedule, Collect::Own, Choice::Sort, config)
}

fn collected(collect: Collect, choice: Choice, config: &Config) -> Built {
    programs::loops::<Lab7>(Which::Outer, dynamic(config), collect, choice, config)
}

/// Looks at the pairs of disc `a` with every disc in `partners`, all of higher numbers than `a`, and appends to `list` the
/// candidates of those that collide in this step.
pub fn look_along(
    discs: &[Disc],
    a: usize,
    partners: Range<usize>,
    radius: f64,
    list: &mut Vec<Candidate>,
) {
    hard_discs::look_along::<Lab7>(discs, a, partners, radius, list);
}

/// Carries out the collisions that were taken, on discs as they were at the start of the step.
pub fn resolve(taken: &[Candidate], discs: &mut [Disc], square: Square) {
    hard_discs::resolve::<Lab7>(taken, discs, square);
}

/// What the library asks for, answered by the functions of the tasks.
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

    fn blocks_around(block: usize) -> Vec<usize> {
        blocks_around(block)
    }

    #[inline(always)]
    fn partners(entries: &[Entry], k: usize) -> Range<usize> {
        partners(entries, k)
    }

    fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize {
        choose_windows(survey, square, crowding)
    }
}
