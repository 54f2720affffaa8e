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
//! | 7.6 | `resolve.rs` | what a collision does to velocities and places |
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
//! The files with tasks are those of the tables. The rest is given, and need not be read: `square.rs`
//! (the square, its discs on the whole), `threads/` (a pool of threads, counts and slots that they
//! share), `search/` (what finds pairs by loops, grid and cells), `engine.rs` (what a step works on),
//! `variants.rs` (the programs).
//!
//! All variants give the same bits, on any scene and with any number of threads: they find the same
//! candidates with the same function, and the decision does not depend on the order in which
//! they were found.

mod append;
mod blocks;
mod candidate;
mod cells;
mod choice;
mod engine;
mod loops;
mod pairs;
mod resolve;
mod schedule;
mod search;
mod square;
mod step;
mod swept;
mod threads;
mod variants;
mod walls;
mod windows;

pub use append::{append_atomic, append_locked};
pub use blocks::{BLOCKS, block_of, blocks_around};
pub use candidate::{Candidate, Hit, order};
pub use cells::{Entry, partners};
pub use choice::{take, take_in_order};
pub use engine::{Choice, Engine};
pub use loops::{inner, nested, outer};
pub use pairs::{LANES, look_along, look_for, may_touch, pair_hit, pair_time};
pub use resolve::{bounce, collide, outcome, push, put_back, resolve, stop_at_wall, travel};
pub use schedule::{Schedule, Team, fixed_part, next_part};
pub use search::{
    AllPairs, Collect, Cut, Deal, Find, Found, Grid, Lattice, Loops, Planned, Searcher, Which,
    Work, expected_work,
};
pub use square::{Square, Survey};
pub use swept::{Span, reach, span};
pub use threads::{LockedCount, SharedCount, Slots, Workers};
pub use variants::VARIANTS;
pub use walls::wall_hit;
pub use windows::{Window, choose_windows};
