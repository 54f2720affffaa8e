//! The tests of lab 2: read them in tests/lab2.rs at the top of the kit.
include!("../../../tests/lab2.rs");
