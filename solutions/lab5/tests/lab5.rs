//! Lab 5's graders, run on the solution.

extern crate solution5 as lab5;
include!("../../../tests/lab5.rs");
