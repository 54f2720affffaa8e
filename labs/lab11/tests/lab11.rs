//! The tests of lab 11: read them in tests/lab11.rs at the top of the kit.
include!("../../../tests/lab11.rs");
