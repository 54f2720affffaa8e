//! Soft discs moved by any integrator, which the user supplies.
//!
//! - [`Integrated`]: all particles take the same step at the same time, with any [`Method`]: drifts
//!   and kicks of a [`System`], or [`RungeKutta`].
//! - [`Located`]: a Runge-Kutta method that ends its steps at contacts and walls. Particles that
//!   could touch within a step form a group, and an event ends only the step of its group.
//! - [`Mixed`]: the official step with positions in single precision, relative to their cell.
//!
//! ```
//! use common::soft::{Scene, Simulation};
//! use integrators::{Integrated, Method, System};
//! use oracle::energy;
//!
//! /// The official step.
//! struct Euler;
//!
//! impl Method for Euler {
//!     fn advance(&self, system: &mut System, dt: f64) {
//!         system.kick(dt);
//!         system.drift(dt);
//!     }
//! }
//!
//! let scene = Scene::official(500, 1)?;
//! let change = |parts| {
//!     // Two threads, and each official step in this number of parts.
//!     let mut engine = Integrated::new(2, Euler, parts, 1.0);
//!     engine.load(&scene);
//!     engine.run(100);
//!     let mut end = scene.particles().to_vec();
//!     engine.read(0, &mut end);
//!     (energy(&end) / energy(scene.particles()) - 1.0).abs()
//! };
//! assert!(change(10) < 0.1 * change(1));
//! # Ok::<(), common::soft::SceneError>(())
//! ```
//!
//! # Rules
//!
//! A type that implements [`Rules`] supplies the slope of a step to [`RungeKutta`] and [`Located`],
//! and the time of an event to [`Located`]. `solution12::Tasks` is such a type.
//!
//! # Units and errors
//!
//! Lengths, times and speeds have the units of the model in [`common::soft`]. A scene is checked
//! when it is built, so nothing here can fail. The results are the same on any number of threads.

mod located;
mod mixed;
mod rules;
mod state;
mod together;

pub use located::Located;
pub use mixed::Mixed;
pub use neighbour_list::DIVIDE;
pub use rules::{Rules, Watched};
pub use state::State;
pub use together::{Integrated, Method, RungeKutta, System};

/// The length of a step in official steps.
pub const STRETCH: common::Parameter = common::Parameter {
    name: "stretch",
    about: "official steps that a step stands for: 2 is a time step of 0.001",
    default: 1.0,
    range: (0.01, 10.0),
};
