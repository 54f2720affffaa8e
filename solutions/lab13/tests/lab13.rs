//! Lab 13's graders, run on the solution.

extern crate solution13 as lab13;
include!("../../../tests/lab13.rs");
