//! A fast engine for soft discs: particles that exert forces on each other only within a cutoff
//! radius.
//!
//! Particles are sorted by cell, so that neighbours in the box are neighbours in memory. A list
//! contains all pairs that could touch before the next rebuild. One pass over the list computes the
//! forces and moves the particles, block by block, in vector registers, on as many threads as you
//! like.
//!
//! ```
//! use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
//! use neighbour_list::{NeighbourList, Workers};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::official(1000, 1)?;
//! // Two threads, 0 for the cheapest skin, and steps that are not divided.
//! let mut engine = NeighbourList::<NoStatistics>::new(Workers::new(2)?, 0.0, 1);
//! engine.load(&scene);
//! engine.run(100);
//! let mut particles = vec![Particle::default(); scene.len()];
//! engine.read(0, &mut particles);
//! # // Compare with the all-pairs program.
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
//! // Or build a list alone, which contains all pairs of near particles.
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
//! **Shapes.** Particles are a structure of arrays, [`Bodies`], in the engine's order: cell by
//! cell. The array `id` contains each particle's index in the scene. A pair is two indices in the
//! engine's order, the smaller one first. A rebuild sorts the particles again, so earlier indices
//! become invalid.
//!
//! **Units.** Lengths are in units of the box, and times in steps of [`DT`](common::soft::DT). The
//! skin that you give to [`NeighbourList::new`] is in cutoffs. Costs ([`LISTED`]) are in
//! nanoseconds.
//!
//! **Errors.** A [`Scene`](common::soft::Scene) is checked when it is made. The only possible error
//! is that the system refuses to start threads ([`Workers::new`]).
//!
//! **Bits.** The results for a scene have the same bits on any number of threads and on any
//! processor.
//!
//! The primitives come from lab 10. If you have your own primitives, use the package
//! `neighbour-list-core`, which contains the engine itself.

pub use neighbour_list_core::*;
pub use solution10::{collect, filter};

/// The engine with the primitives of lab 10 and an observer `O`.
pub type NeighbourList<O> = neighbour_list_core::NeighbourList<O, solution10::Tasks>;

/// Memory for pairs within the cutoff, and their accelerations.
pub type Contacts = neighbour_list_core::Contacts<solution10::Tasks>;

/// The neighbour list: the pairs that may touch before the next rebuild.
pub mod list {
    pub use neighbour_list_core::list::*;

    /// The pairs that may come within the cutoff before the list expires.
    pub type Neighbours = neighbour_list_core::list::Neighbours<solution10::Tasks>;
}
