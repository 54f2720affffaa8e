//! The tests of lab 5: read them in tests/lab5.rs at the top of the kit.
include!("../../../tests/lab5.rs");
