//! Lab 4's graders, run on the solution.
#![allow(unexpected_cfgs)]

extern crate solution4 as lab4;
// The analysis of an editor cannot load files from outside the package. The compiler can.
#[cfg(not(rust_analyzer))]
include!("../../../tests/lab4.rs");
