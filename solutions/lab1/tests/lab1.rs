//! Lab 1's graders, run on the solution.

extern crate solution1 as lab1;
include!("../../../tests/lab1.rs");
