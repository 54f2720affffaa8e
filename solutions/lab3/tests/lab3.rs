//! Lab 3's graders, run on the solution.
#![allow(unexpected_cfgs)]

extern crate solution3 as lab3;
// An editor's analysis cannot load what lies outside a package; its compiler can.
#[cfg(not(rust_analyzer))]
include!("../../../tests/lab3.rs");
