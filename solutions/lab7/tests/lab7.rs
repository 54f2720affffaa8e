//! Lab 7's graders, run on the solution.

extern crate solution7 as lab7;
include!("../../../tests/lab7.rs");
