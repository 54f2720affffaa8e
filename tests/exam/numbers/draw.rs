//! Numbers that a paper may change.
//!
//! In a question, a comment behind such a number contains its name: `5<!--share--> %`.

use std::collections::BTreeMap;

use oracle::Random;

/// Source of the numbers that questions print.
pub enum Draw {
    /// The numbers of the book.
    Book,
    /// Random choices.
    Seeded(Random),
    /// The numbers of a printed paper, by question and name.
    Printed(Shown),
}

/// Numbers by question and name, such as `3.1 share`.
pub type Shown = BTreeMap<String, f64>;

/// Numbers that questions print, and their source.
pub struct Inputs {
    source: Draw,
    /// Numbers that the questions and answers print.
    pub shown: Shown,
}

impl Inputs {
    /// Makes inputs without numbers.
    pub fn of(source: Draw) -> Self {
        Self { source, shown: Shown::new() }
    }

    /// Chooses a number that a question prints. The first of `choices` is the book's.
    pub fn one(&mut self, name: &str, choices: &[f64]) -> f64 {
        let chosen = match &mut self.source {
            Draw::Book => choices[0],
            Draw::Seeded(random) => choices[random.below(choices.len())],
            Draw::Printed(shown) => shown.get(name).copied().unwrap_or(choices[0]),
        };
        self.also(name, chosen)
    }

    /// Adds a number that follows from others and is printed too.
    pub fn also(&mut self, name: &str, value: f64) -> f64 {
        self.shown.insert(name.into(), value);
        value
    }
}
