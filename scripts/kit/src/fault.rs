//! Faults to find, as `labs/labN/faults/*.json` holds them: a known-wrong program, what a test says of it, and four
//! explanations, of which one is right.
//!
//! `cargo lab prove --record` writes them, from a file of tests/wrong, the questions beside it, and a run.

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use crate::files::{read_text, sources_below};
use crate::kit::Kit;
use crate::lab::Lab;

/// A known-wrong program, and what may be wrong with it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fault {
    /// What it is called: the name of its file.
    pub name: String,
    /// Its region, such as 3.2b.
    pub region: String,
    /// What the region has to do.
    pub title: String,
    /// The function that the region is in.
    pub code: String,
    /// A test that it fails.
    pub test: String,
    /// What the test says: what the program gives, and what the right one gives.
    pub message: String,
    /// What may be wrong.
    pub choices: Vec<Choice>,
    /// What is wrong.
    pub story: String,
}

/// An explanation of what a test says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Choice {
    /// The line that it blames, from 1.
    pub line: usize,
    /// Why.
    pub why: String,
    /// Why it cannot be so; none for the right one.
    pub refutation: Option<String>,
}

/// The faults of a lab, by their names; none if it has no such folder.
pub fn read(kit: &Kit, lab: Lab) -> Result<Vec<Fault>> {
    let of = |path: std::path::PathBuf| {
        let unread = || format!("cannot read {}", path.display());
        serde_json::from_str(&read_text(&path)?).with_context(unread)
    };
    sources_below(&kit.starter(lab).join("faults"))?.into_iter().map(of).collect()
}
