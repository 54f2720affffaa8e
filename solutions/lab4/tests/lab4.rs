//! Lab 4's graders, run on the solution.

extern crate solution4 as lab4;
include!("../../../tests/lab4.rs");
