//! Lab 11's graders, run on the solution.

extern crate solution11 as lab11;
include!("../../../tests/lab11.rs");
