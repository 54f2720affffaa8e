//! The graders' side of the hard discs (labs 7, 8 and 9). It contains an independent implementation
//! of the model, scenes that expose wrong programs, questions about whole runs, and the exact
//! motion that the model approximates.

mod compare;
mod events;
mod model;
mod runs;
pub mod scenes;
mod states;

pub use compare::{difference, one_step};
pub use events::Exact;
pub use model::{Event, What, first_touch, possible, step, wait_at_wall};
pub use runs::Runs;
pub use states::{follow, of_each_step, split, state};
