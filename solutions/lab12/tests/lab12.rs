//! Lab 12's graders, run on the solution.

extern crate solution12 as lab12;
include!("../../../tests/lab12.rs");
