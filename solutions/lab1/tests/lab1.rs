extern crate solution1 as lab1;
include!("../../../tests/lab1.rs");
