//! A fast engine for soft discs: particles that only feel each other within a cutoff radius.
//!
//! Particles are sorted by cell, so that neighbours in the box are neighbours in memory. A list holds all
//! pairs that could touch until the next rebuild. One pass over it computes the forces and moves the
//! particles, block by block, in vector registers, on as many threads as you like.
//!
//! ```
//! use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
//! use neighbour_list::{NeighbourList, Workers};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::official(1000, 1)?;
//! // Two threads, the cheapest skin, and one small step for each step.
//! let mut engine = NeighbourList::<NoStatistics>::new(Workers::new(2)?, 0.0, 1);
//! engine.load(&scene);
//! engine.run(100);
//! let mut particles = vec![Particle::default(); scene.len()];
//! engine.read(0, &mut particles);
//! # // As all pairs say.
//! # let all_pairs = solution1::VARIANTS.iter().find(|v| v.name == "all-pairs").ok_or("none")?;
//! # let mut model = (all_pairs.build)(&all_pairs.config())?;
//! # model.load(&scene);
//! # model.run(100);
//! # let mut expected = particles.clone();
//! # model.read(0, &mut expected);
//! # for (found, expected) in particles.iter().zip(&expected) {
//! #     assert!((found.x - expected.x).hypot(found.y - expected.y) < 1e-9, "{found:?}, {expected:?}");
//! # }
//!
//! // Or a list alone: whose pairs are near?
//! use neighbour_list::{Bodies, list::Neighbours};
//!
//! let mut bodies = Bodies::of(&scene);
//! let skin = 0.5 * CUTOFF;
//! let mut list = Neighbours::default();
//! list.rebuild(&mut bodies, skin, scene.size(), &Workers::default());
//! for [i, j] in list.blocks.iter().flat_map(|block| &block.outer.inside) {
//!     let [i, j] = [*i, *j].map(|k| k as usize);
//!     let distance = (bodies.x[i] - bodies.x[j]).hypot(bodies.y[i] - bodies.y[j]);
//!     assert!(distance < 1.001 * (CUTOFF + skin));
//! }
//! # Ok(())
//! # }
//! ```
//!
//! **Shapes.** Particles are a structure of arrays, [`Bodies`], in the engine's own order: cell by cell.
//! `id` says which particle of the scene each is. A pair is two indices of that order, the smaller one
//! first. A rebuild sorts anew, and indices from before it mean other particles.
//!
//! **Units.** Lengths are those of the box, times are steps of [`DT`](common::soft::DT), a skin given to
//! [`NeighbourList::new`] is in cutoffs. Costs ([`LISTED`]) are nanoseconds.
//!
//! **Errors.** A [`Scene`](common::soft::Scene) was checked when it was made. Only threads that the system refuses are an
//! error ([`Workers::new`]).
//!
//! **Bits.** The same scene gives the same bits on any number of threads and on any processor.
//!
//! Its primitives are those of lab 10. The engine itself is `neighbour-list-core`, for somebody who has primitives of
//! their own.

pub use neighbour_list_core::*;
pub use solution10::{collect, filter};

/// The engine, seen by an observer `O`.
pub type NeighbourList<O> = neighbour_list_core::NeighbourList<O, solution10::Tasks>;

/// Pairs within the cutoff, and their accelerations.
pub type Contacts = neighbour_list_core::Contacts<solution10::Tasks>;

/// The neighbour list: which particles might touch until the next rebuild.
pub mod list {
    pub use neighbour_list_core::list::*;

    /// The pairs that may come near each other until the list has expired.
    pub type Neighbours = neighbour_list_core::list::Neighbours<solution10::Tasks>;
}
