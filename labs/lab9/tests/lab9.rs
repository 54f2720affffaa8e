//! The tests of lab 9: read them in tests/lab9.rs at the top of the kit.
include!("../../../tests/lab9.rs");
