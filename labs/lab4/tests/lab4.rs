//! The tests of lab 4: read them in tests/lab4.rs at the top of the kit.
include!("../../../tests/lab4.rs");
