//! Given code for every lab: the models, their scenes and files, and the program around a lab.
//!
//! Read it in this order:
//!
//! 1. [`soft::Particle`] and the constants of [`soft`]: the model of labs 1 to 6, 9 and 10.
//! 2. [`soft::Scene`]: particles in a box, checked once, so that labs need no checks.
//! 3. [`soft::Simulation`]: the interface of a lab's engine: load a scene, step, read the
//!    particles.
//! 4. [`hard`]: a model, a scene and an interface for the colliding discs of labs 7, 8 and 9.
//! 5. [`Variant`]: an entry in a lab's list of programs. One driver, one test harness and one
//!    benchmark work with all variants.

mod event;
mod program;
mod room;
mod scene_error;
mod threads;
mod variant;
mod vec2;
mod whole_file;

pub mod hard;
pub mod soft;

pub use event::{Activity, Event, EventError};
pub use scene_error::SceneError;
pub use variant::{
    BuildError, Config, Parameter, ParameterError, Reproducibility, Variant, bitwise, deterministic,
};
pub use vec2::Vec2;
pub use whole_file::write_whole;
