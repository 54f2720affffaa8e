//! Tests that the symbols and strings of the program that runs a submission reveal no right answer.

use std::fs;
use std::process::Command;
use std::time::Duration;

use super::{PROBE, Tree};
use crate::asking::{ANSWER, JUDGE};
use crate::sandbox::{Limits, Sandbox};
use lab_kit::Kit;

/// Texts that occur only in a program that contains right answers.
///
/// Each is a part of a symbol of the code that compares or computes answers, or a text that only a
/// verdict contains.
const KNOWING: [&str; 7] = [
    "6oracle5model",
    "6oracle9diagnosis",
    "6oracle7compare",
    "6oracle5right",
    "the bits differ from those of all-pairs",
    "which is not along the line between",
    // The digest of the official output.
    "374fe976d9f1d1f831a0a6fadf3339c23bbeca62a7eadd62dc8c8db1fc735357",
];

#[test]
fn the_program_that_runs_a_submission_knows_no_answer() {
    let kit = Kit::find().unwrap();
    let limit = Duration::from_secs(900);
    // This test runs no code of a submission.
    let sandbox =
        Sandbox::find(&kit, true, Limits { run: limit, build: limit, loopback: false }).unwrap();
    let tree = Tree::lay(&kit, "1".parse().unwrap(), &sandbox).unwrap();
    let root = tree.folder.path();
    super::put(root, tree.lab, &lab_kit::sources::of_solution(&kit, tree.lab).unwrap(), &sandbox)
        .unwrap();
    tree.programs.show(&root.join(super::PACKAGE)).unwrap();
    // Debugging information is left out, because it names functions that are not in the program.
    let mut cargo = Command::new("cargo");
    cargo.current_dir(root).args(["build", "--quiet", "--offline", "--release"]);
    cargo.args(["--config", "profile.release.debug=false"]);
    cargo.args(["--package", PROBE, "--target-dir", "target/symbols"]);
    assert!(cargo.status().unwrap().success());
    let programs = root.join("target/symbols/release");
    let [judge, answer] = [JUDGE, ANSWER].map(|name| fs::read(programs.join(name)).unwrap());
    for word in KNOWING {
        assert!(has(&judge, word), "the judging program has no '{word}': look for another word");
        assert!(!has(&answer, word), "the program that runs a submission has '{word}'");
    }
}

fn has(program: &[u8], word: &str) -> bool {
    program.windows(word.len()).any(|window| window == word.as_bytes())
}
