//! Soft discs in windows: an engine that skips the work that a scene does not need.
//!
//! If most particles touch no other particle, the engine opens a *window* of several steps.
//! Particles that could meet in the window form small *groups*. Each group is computed alone from
//! the start of the window to its end, in the processor's registers. All other particles fly freely
//! and are moved once per window. At the end the engine tests how far each particle in a group
//! deviated from its free flight. If a pair may have been missed, the groups of its particles are
//! united and computed again. If most particles have neighbours, windows are not worth their cost,
//! and [`Planned`] uses the neighbour list of lab 10 instead.
//!
//! The results do not depend on the windows. Groups sum over pairs in ascending order of ids, and
//! free flight makes the same additions as single steps. So windows give the same bits as the naive
//! program, on any number of threads; a list gives the same positions up to rounding.
//!
//! # Rules
//!
//! A type that implements [`Rules`] decides which particles could meet, how far a path may bend,
//! and how long a window should be. Use `solution11::Tasks` for speed. The type below is cautious:
//! it assumes that all particles near each other may meet. So hardly any work is skipped, and the
//! bits are the same.
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
//! // Two threads, windows of 4 steps, and official steps that are not divided.
//! let mut planned = Planned::<Careful, NoStatistics>::new(Workers::if_possible(2), 4, 1);
//! let mut naive = AllPairs::<NoStatistics>::default();
//! assert_eq!(end(&mut planned, &scene), end(&mut naive, &scene));
//! # Ok::<(), common::soft::SceneError>(())
//! ```
//!
//! # Units and errors
//!
//! Lengths, times and speeds have the units of the model in [`common::soft`]. A scene is checked
//! when it is built, so nothing here can fail.
//!
//! # Modules
//!
//! | module | contents |
//! |--------|----------|
//! | `rules` | the decisions that the engine leaves to a type that implements [`Rules`] |
//! | `span` | the steps of a window, and the box |
//! | `path` | the path of a particle that no force bends |
//! | `search` | the particles that could meet in a window |
//! | `groups` | groups of particles, and their run through a window |
//! | `window` | a window from its opening to its end, and the pairs that it missed |
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
