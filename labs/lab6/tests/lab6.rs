//! The tests of lab 6: read them in tests/lab6.rs at the top of the kit.
include!("../../../tests/lab6.rs");
