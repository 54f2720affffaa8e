//! The tests of lab 8: read them in tests/lab8.rs at the top of the kit.
include!("../../../tests/lab8.rs");
