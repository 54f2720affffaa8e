//! Hard discs: an engine for discs that fly straight until they hit a wall or each other.
//!
//! A step consists of a search and a decision. The search finds the *candidates*: all collisions
//! that could happen in the step. The decision goes through the candidates in order of time, and
//! takes a candidate if its discs have not collided yet in this step. This library contains
//! searches ([`Find`]) and the engine around them ([`Engine`]). The user's type makes the
//! decisions; it implements these traits:
//!
//! | trait | decisions | used by |
//! |-------|-----------|---------|
//! | [`Collisions`] | times of collisions, order of candidates, effect of a collision | all |
//! | [`Step`] | the order of search, decision and move | [`Engine`] |
//! | [`ParallelLoops`] | how threads share loops | [`Loops`], [`Grid`] |
//! | [`BroadPhase`] | swept boxes, blocks, cells, windows of time | [`Grid`], [`Planned`] |
//!
//! The compiler resolves the calls: it compiles an engine for each such type, and inlines the
//! functions.
//!
//! | search | pairs that it tests | work of the threads |
//! |--------|---------------------|---------------------|
//! | [`AllPairs`] | all | there is one thread |
//! | [`Loops`] | all | they share one of the two loops, or both |
//! | [`Grid`] | pairs in overlapping blocks, of 4 × 4, 2 × 2 and 1 | they share the discs |
//! | [`Planned`] | pairs whose swept boxes share cells | they share discs, then strips |
//!
//! All searches find the same candidates. So the bits are the same with each search and on any
//! number of threads.
//!
//! # Example
//!
//! Two marbles in a row meet head-on, and a search finds their collision:
//!
//! ```
//! use std::cmp::Ordering;
//!
//! use common::hard::{Disc, Scene};
//! use hard_discs::{AllPairs, Candidate, Collisions, Find, Found, Hit, Square, Window};
//!
//! struct Marbles;
//!
//! impl Collisions for Marbles {
//!     fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate> {
//!         let left = &discs[a as usize];
//!         let right = &discs[b as usize];
//!         let time = (right.x - left.x - 2.0 * radius) / (left.vx - right.vx);
//!         (0.0..1.0).contains(&time).then_some(Candidate { time, hit: Hit::Pair(a, b) })
//!     }
//!     fn order(a: &Candidate, b: &Candidate) -> Ordering {
//!         a.time.total_cmp(&b.time)
//!     }
//!     fn collide(a: &mut Disc, b: &mut Disc, _: f64, _: Square) {
//!         std::mem::swap(&mut a.vx, &mut b.vx);
//!     }
//!     // No walls.
//!     fn wall_hit(_: u32, _: &Disc, _: Square) -> Option<Candidate> {
//!         None
//!     }
//!     fn bounce(_: &mut Disc, _: f64, _: Hit, _: Square) {}
//!     // All collisions happen.
//!     fn take_in_order(all: &mut [Candidate], _: &mut [bool], taken: &mut Vec<Candidate>) {
//!         taken.extend_from_slice(all);
//!     }
//! }
//!
//! let marbles = vec![Disc::new(2.0, 5.0, 1.0, 0.0), Disc::new(6.0, 5.0, -3.0, 0.0)];
//! let scene = Scene::new(10.0, 1.0, marbles).unwrap();
//! let mut found = Found::default();
//! found.clear(1);
//! let mut search = AllPairs::<Marbles>::default();
//! search.find(scene.discs(), &[true; 2], Square::of(&scene), Window::STEP, &mut found);
//! assert_eq!(found.lists[0], [Candidate { time: 0.5, hit: Hit::Pair(0, 1) }]);
//! ```
//!
//! # Shapes, units, errors
//!
//! Discs are a slice, and a disc's number is its index. All discs have the same radius and mass.
//! Lengths are in the scene's unit, times in steps (λ, from 0 to 1), velocities in lengths per
//! step. A [`Scene`](common::hard::Scene) is checked when it is made, so nothing here fails on bad
//! input. The only possible error is that the system refuses to start threads ([`Workers::new`]).
//! The memory of a step is proportional to the number of discs and candidates.

mod broad_phase;
mod cells;
mod choice;
mod collisions;
mod engine;
mod entry;
mod find;
mod geometry;
mod grid;
mod loops;
mod pairs;
mod parallel_loops;
pub mod programs;
mod survey;
mod threads;

pub use broad_phase::BroadPhase;
pub use cells::{Planned, Work, expected_work};
pub use choice::Choice;
pub use collisions::{Candidate, Collisions, Hit, resolve};
pub use engine::{Engine, Step};
pub use entry::Entry;
pub use find::{Find, Found};
pub use geometry::{Span, Square, Window, reach};
pub use grid::{BLOCKS, Deal, Grid};
pub use loops::{AllPairs, Collect, Loops};
pub use pairs::{LANES, look_along, look_for, may_touch};
pub use parallel_loops::{ParallelLoops, Which};
pub use survey::Survey;
pub use threads::{LockedCount, Schedule, SharedCount, Slots, Team};
pub use workers::Workers;
