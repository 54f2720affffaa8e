//! The tests of lab 10: read them in tests/lab10.rs at the top of the kit.
include!("../../../tests/lab10.rs");
