//! Keeping the kit: [`starter`] writes labs from their solutions, [`prove`] proves that the graders
//! grade, [`handout`] lays out the kit as students of a lab get it, [`classroom`] tells Classroom 50 of its tasks.

pub mod classroom;
pub mod figures;
pub mod handout;
pub mod prove;
pub mod starter;
