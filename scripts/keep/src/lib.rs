//! Commands for maintaining the kit: [`starter`] writes labs from their solutions, [`prove`] proves
//! that the graders grade, [`handout`] writes the kit of a class, [`classroom`] writes a lab's
//! tests for Classroom 50, and [`figures`] draws the book's charts.

pub mod classroom;
pub mod figures;
pub mod handout;
pub mod prove;
pub mod starter;
