//! The exam questions: their numbers are computed, and papers are drawn from them.
//!
//! `cargo test --doc -p exam` compiles the Rust in the questions.

pub mod bank;
pub mod numbers;
pub mod paper;

macro_rules! pages {
    ($($lab:ident)*) => {
        $(
            #[cfg(doctest)]
            #[doc = include_str!(concat!("../../book/src/instructor/exam/", stringify!($lab), ".md"))]
            mod $lab {}
        )*
    };
}

pages!(lab1 lab2 lab3 lab4 lab5 lab6 lab7 lab8 lab9 lab10 lab11 lab12 lab13);
