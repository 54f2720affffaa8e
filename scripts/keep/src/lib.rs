//! Keeping the kit: [`starter`] writes labs from their solutions, [`prove`] proves that the graders
//! grade, [`modules`] finds modules that import each other, [`handout`] lays out the kit as students of a
//! lab get it.

pub mod handout;
pub mod modules;
pub mod prove;
pub mod starter;
