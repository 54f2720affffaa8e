//! Lab 2's graders, run on the solution.

extern crate solution2 as lab2;
include!("../../../tests/lab2.rs");
