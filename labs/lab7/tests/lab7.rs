//! The tests of lab 7: read them in tests/lab7.rs at the top of the kit.
include!("../../../tests/lab7.rs");
