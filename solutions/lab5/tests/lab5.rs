//! Lab 5's graders, run on the solution.
#![allow(unexpected_cfgs)]

extern crate solution5 as lab5;
// The analysis of an editor cannot load files from outside the package. The compiler can.
#[cfg(not(rust_analyzer))]
include!("../../../tests/lab5.rs");
