//! Lab 6's graders, run on the solution.

extern crate solution6 as lab6;
include!("../../../tests/lab6.rs");
