//! Lab 2's graders, run on the solution.
#![allow(unexpected_cfgs)]

extern crate solution2 as lab2;
// An editor's analysis cannot load what lies outside a package; its compiler can.
#[cfg(not(rust_analyzer))]
include!("../../../tests/lab2.rs");
