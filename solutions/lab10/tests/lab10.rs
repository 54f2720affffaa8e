//! Lab 10's graders, run on the solution.

extern crate solution10 as lab10;
include!("../../../tests/lab10.rs");
