//! Table of the proofs.

use lab_kit::Lab;

/// Result of one proof.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) lab: Lab,
    /// Subject of the proof, such as `solution`.
    pub(crate) what: String,
    /// Number of tests that ran.
    pub(crate) tests: usize,
    /// Whether the proof succeeded.
    pub(crate) result: Proof,
    /// Faults, or the reason why the proof was skipped.
    pub(crate) faults: Vec<String>,
}

/// Whether a proof succeeded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// The proof succeeded. The text appears as the result in the table.
    Proven(&'static str),
    /// The proof failed.
    Faulty,
    /// The proof was not tried, because software is missing.
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

/// Prints the table, the faults, and the total.
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
    let faulty = rows.iter().filter(|row| row.result == Proof::Faulty).count();
    let skipped = rows.iter().filter(|row| row.result == Proof::Skipped).count();
    let proven = rows.len() - faulty - skipped;
    println!("\n{proven} proven, {faulty} faulty, {skipped} skipped");
}
