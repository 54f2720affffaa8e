//! The tests of lab 13: read them in tests/lab13.rs at the top of the kit.
include!("../../../tests/lab13.rs");
