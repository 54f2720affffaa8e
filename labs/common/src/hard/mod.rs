//! Hard discs: discs that fly straight and collide with each other and with the walls (labs 7, 8
//! and 9).
//!
//! The problem is Assignment 1 of NUS's CS3210: N discs of radius r in a square of side L, in time
//! steps of length 1. In one step a disc takes part in at most one collision. If several collisions
//! could happen, the earliest comes first, and its discs have no other collision in the step; this
//! rule is part of the model. Chapter 7 of the book states every rule, and the labs implement them.

mod disc;
mod driver;
mod input;
mod output;
mod random;
mod scene;
mod simulation;
mod words;

pub use crate::SceneError;
pub use disc::Disc;
pub use driver::{drive, drive_on_rank};
pub use input::{Mode, Problem, read_problem};
pub use output::{write_end, write_step};
pub use random::RandomScene;
pub use scene::Scene;
pub use simulation::Simulation;
pub use words::InputError;
