//! Lab 9's graders, run on the solution.

extern crate solution9 as lab9;
include!("../../../tests/lab9.rs");
