//! Lab 7, collisions: discs that fly straight until they hit a wall or each other.
//!
//! A step of hard discs is a search and a decision. The search looks for all collisions that could
//! happen in the step: the *candidates*. Disc by disc for walls, pair by pair for discs, it can be
//! done by many threads in any order. The decision goes through the candidates in order of time
//! and takes each whose discs have not collided yet in this step; it is serial, and short.
//!
//! The search has n (n − 1) / 2 pairs, nearly all of them far apart. The first half of this lab
//! shares these out among threads, in the ways that the CS3210 report tried. The second half does
//! not look at them: it cuts space into cells and the step into windows of time.
//!
//! | task | file | what |
//! |------|------|------|
//! | 7.1 | `walls.rs` | when a disc hits a wall |
//! | 7.2 | `pairs.rs` | when two discs touch |
//! | 7.3 | `candidate.rs` | which of two candidates comes first |
//! | 7.4 | `greedy.rs` | which candidates happen |
//! | 7.5 | `resolve.rs` | who would leave the square waits at the wall |
//! | 7.6 | `resolve.rs` | what a collision does to velocities and places |
//! | 7.7 | `engine.rs` | one step |
//! | 7.8 | `loops.rs` | all pairs |
//! | 7.9 | `schedule.rs` | a loop dealt out: fixed parts, a queue |
//! | 7.10 | `choice.rs` | sorted lists merged |
//! | 7.11 | `choice.rs` | the earliest selected, without a sort |
//! | 7.12 | `swept.rs` | the box that a disc sweeps |
//! | 7.13 | `grid.rs` | a grid of three levels |
//! | 7.14 | `cells.rs` | sorted occupied cells |
//! | 7.15 | `lattice.rs` | how many windows of time |
//!
//! All variants give the same bits, on any scene and with any number of threads: they find the same
//! candidates with the same function, and the decision does not depend on the order in which
//! they were found.

mod candidate;
mod cells;
mod choice;
mod engine;
mod find;
mod greedy;
mod grid;
mod lattice;
mod loops;
mod pairs;
mod planned;
mod radix;
mod resolve;
mod schedule;
mod shared_count;
mod square;
mod swept;
mod variants;
mod walls;
mod workers;

pub use candidate::{Candidate, Hit, order};
pub use cells::{Entry, Strip, for_each_meeting};
pub use choice::{Choice, merge, take_earliest};
pub use engine::Engine;
pub use find::{Find, Found, Window};
pub use greedy::{take, take_in_order};
pub use grid::{BLOCKS, Grid, block_of, blocks_around};
pub use lattice::{Lattice, choose_windows, expected_work};
pub use loops::{AllPairs, Loops, Which, look_along};
pub use pairs::{may_touch, pair_hit, pair_time};
pub use planned::Planned;
pub use resolve::{bounce, collide, push, resolve, stop_at_wall, travel};
pub use schedule::{Schedule, Team, fixed_part, next_part};
pub use shared_count::SharedCount;
pub use square::Square;
pub use swept::{Span, Survey, reach, span};
pub use variants::VARIANTS;
pub use walls::wall_hit;
pub use workers::Workers;
