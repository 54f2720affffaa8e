//! The tests of lab 1: read them in tests/lab1.rs at the top of the kit.
include!("../../../tests/lab1.rs");
