//! Lab 8's graders, run on the solution.

extern crate solution8 as lab8;
include!("../../../tests/lab8.rs");
