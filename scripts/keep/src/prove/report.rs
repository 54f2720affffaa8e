//! What was proven, as a table.

use lab_kit::Lab;

/// One thing that had to be proven.
#[derive(Debug)]
pub(crate) struct Row {
    /// The lab.
    pub(crate) lab: Lab,
    /// What it is about, such as `solution`.
    pub(crate) what: String,
    /// How many tests were asked.
    pub(crate) tests: usize,
    /// Whether it is as it must be.
    pub(crate) result: Proof,
    /// What is not as it must be; or why it was skipped.
    pub(crate) faults: Vec<String>,
}

/// What came of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// As it must be, in the table's words.
    Proven(&'static str),
    /// Not as it must be.
    Faulty,
    /// Not tried: the system lacks something.
    Skipped,
}

impl Proof {
    fn word(self) -> &'static str {
        match self {
            Self::Proven(how) => how,
            Self::Faulty => "FAULT",
            Self::Skipped => "skipped",
        }
    }
}

/// Prints the table, what is wrong with the faulty rows, and the sum.
pub(crate) fn print(rows: &[Row]) {
    let width = rows.iter().map(|row| row.what.len()).max().unwrap_or(0).max(4);
    println!("lab  {:width$}  tests  result", "what");
    for Row { lab, what, tests, result, .. } in rows {
        println!("{lab:>3}  {what:width$}  {tests:>5}  {}", result.word());
    }
    for row in rows.iter().filter(|row| !row.faults.is_empty()) {
        println!("\nlab {}, {}:", row.lab, row.what);
        for fault in &row.faults {
            println!("  {}", fault.trim_end().replace('\n', "\n  "));
        }
    }
    let count = |is: fn(Proof) -> bool| rows.iter().filter(|row| is(row.result)).count();
    println!(
        "\n{} proven, {} faulty, {} skipped",
        count(|result| matches!(result, Proof::Proven(_))),
        count(|result| result == Proof::Faulty),
        count(|result| result == Proof::Skipped)
    );
}
