//! Hard discs: discs that fly straight and collide with each other and the walls (labs 7, 8, 9).
//!
//! This is the problem of NUS's CS3210, Assignment 1: N discs of radius r in a square of side L,
//! in time steps of length 1. In one step a disc takes part in at most one collision. Which ones
//! happen, if several could, is the model's own rule: the earliest first, and each takes its discs
//! out of the step. Chapter 7 of the book states every rule; the labs implement them.

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
