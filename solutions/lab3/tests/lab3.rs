//! Lab 3's graders, run on the solution.

extern crate solution3 as lab3;
include!("../../../tests/lab3.rs");
