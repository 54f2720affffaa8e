//! The tests of lab 12: read them in tests/lab12.rs at the top of the kit.
include!("../../../tests/lab12.rs");
