//! The tests of lab 3: read them in tests/lab3.rs at the top of the kit.
include!("../../../tests/lab3.rs");
