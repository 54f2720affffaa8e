//! What was proven, as a table.

use lab_kit::Lab;

/// One thing that had to be proven.
#[derive(Debug)]
pub(crate) struct Row {
    /// The lab.
    pub(crate) lab: Lab,
    /// What kind of program it is about.
    pub(crate) kind: Kind,
    /// The name of a wrong solution; else empty.
    pub(crate) name: String,
    /// How many tests were asked.
    pub(crate) tests: usize,
    /// Whether it is as it must be.
    pub(crate) result: Proof,
    /// What is not as it must be; or why it was skipped.
    pub(crate) faults: Vec<String>,
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The solution must pass.
    Solution,
    /// The starter must fail at its todos.
    Starter,
    /// A wrong solution must be caught.
    Wrong,
}

/// What came of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// As it must be.
    Proven,
    /// Not as it must be.
    Faulty,
    /// Not tried: the system lacks something.
    Skipped,
}

impl Row {
    fn what(&self) -> String {
        match self.kind {
            Kind::Solution => "solution".into(),
            Kind::Starter => "starter".into(),
            Kind::Wrong => format!("wrong: {}", self.name),
        }
    }

    fn verdict(&self) -> &'static str {
        match (self.result, self.kind) {
            (Proof::Skipped, _) => "skipped",
            (Proof::Faulty, _) => "FAULT",
            (Proof::Proven, Kind::Solution) => "passes",
            (Proof::Proven, Kind::Starter) => "fails at its todos",
            (Proof::Proven, Kind::Wrong) => "caught",
        }
    }
}

/// Prints the table, what is wrong with the faulty rows, and the sum.
pub(crate) fn print(rows: &[Row]) {
    let width = rows.iter().map(|row| row.what().len()).max().unwrap_or(0).max(4);
    println!("lab  {:width$}  tests  result", "what");
    for row in rows {
        println!("{:>3}  {:width$}  {:>5}  {}", row.lab, row.what(), row.tests, row.verdict());
    }
    for row in rows.iter().filter(|row| !row.faults.is_empty()) {
        println!("\nlab {}, {}:", row.lab, row.what());
        for fault in &row.faults {
            println!("  {}", fault.trim_end().replace('\n', "\n  "));
        }
    }
    let count = |result| rows.iter().filter(|row| row.result == result).count();
    println!(
        "\n{} proven, {} faulty, {} skipped",
        count(Proof::Proven),
        count(Proof::Faulty),
        count(Proof::Skipped)
    );
}
