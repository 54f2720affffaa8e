//! Soft discs in windows: an engine that leaves out what a scene does not need.
//!
//! Where most particles touch no other, a window of several steps is opened. The particles that could
//! meet within it form small groups, and each group is computed on its own from the beginning of the
//! window to its end, while it is in the processor's registers. All other particles fly freely and are
//! visited once. At the end of a window each particle's deviation from its free flight is looked at, and where
//! a pair may have been missed, its groups are joined and computed again. Where most particles have neighbours
//! windows do not pay: then [`Planned`] goes on with the neighbour list of lab 10.
//!
//! Nothing of it shows in the results. Groups sum their pairs by ascending id and free flight makes the additions of
//! step by step, so windows have the bits of the naive program, on any number of threads; a list has them
//! to the last digits.
//!
//! # Rules
//!
//! Which particles could meet, how far a path may bend, how long a window should be: a type that implements [`Rules`]
//! decides. `solution11::Tasks` is the one to take for speed. This one is careful: particles near each other
//! may meet, so hardly anything is skipped, and the bits are the same.
//!
//! ```
//! use common::soft::{NoStatistics, Particle, Scene, Simulation};
//! use solution1::AllPairs;
//! use neighbour_list::Workers;
//! use windows::{Planned, Rules, Span};
//!
//! struct Careful;
//!
//! impl Rules for Careful {
//!     fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
//!         (0..steps).for_each(|_| x.iter_mut().zip(v).for_each(|(x, v)| *x += v * dt));
//!     }
//!     fn meets_wall(_: &Span, _: f64, _: f64, _: f64, _: f64) -> bool {
//!         true
//!     }
//!     fn closest_squared(_: f64, _: f64, _: f64, _: f64, _: f64) -> f64 {
//!         0.0
//!     }
//!     fn too_far_off(_: f64, _: f64) -> bool {
//!         true
//!     }
//!     fn root(parent: &mut [u32], k: u32) -> u32 {
//!         parent[k as usize]
//!     }
//!     fn join(parent: &mut [u32], a: u32, b: u32) {
//!         let [a, b] = [a, b].map(|k| parent[k as usize]);
//!         parent.iter_mut().filter(|root| **root == a.max(b)).for_each(|root| *root = a.min(b));
//!     }
//!     fn window_length(_: f64, _: f64) -> u32 {
//!         4
//!     }
//! }
//!
//! fn end(engine: &mut dyn Simulation, scene: &Scene) -> Vec<Particle> {
//!     engine.load(scene);
//!     engine.run(20);
//!     let mut particles = vec![Particle::default(); scene.len()];
//!     engine.read(0, &mut particles);
//!     particles
//! }
//!
//! let scene = Scene::official(200, 1)?;
//! // Two threads, windows of 4 steps, each official step as one.
//! let mut planned = Planned::<Careful, NoStatistics>::new(Workers::if_possible(2), 4, 1);
//! let mut naive = AllPairs::<NoStatistics>::default();
//! assert_eq!(end(&mut planned, &scene), end(&mut naive, &scene));
//! # Ok::<(), common::soft::SceneError>(())
//! ```
//!
//! # Units and errors
//!
//! Lengths, times and speeds are those of the model in [`common::soft`]. A scene is checked when it is
//! built, so nothing here can fail.
//!
//! # Modules
//!
//! | module | what |
//! |--------|------|
//! | `rules`, `span` | what is asked of the user, and what the rules are told |
//! | `path` | where a particle goes if no force bends its path |
//! | `search` | which particles could meet in a window |
//! | `groups` | groups of particles, and running them through a window |
//! | `window` | a window from its opening to its end, and what it missed |
//! | `planned` | the planner and the engine |

mod groups;
mod path;
mod planned;
pub mod programs;
mod rules;
mod search;
mod span;
mod window;

pub use planned::{Plan, Planned, Strategy, plan};
pub use rules::Rules;
pub use span::Span;
