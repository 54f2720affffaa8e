//! The graders' side of the hard discs (labs 7, 8 and 9): the model a second time, scenes on which
//! wrong programs show, a check step by step, and the exact motion that the model approximates.

mod events;
mod grader;
mod model;
pub mod scenes;

pub use events::Exact;
pub use grader::{Grader, difference, one_step};
pub use model::{Event, What, first_touch, possible, step};
