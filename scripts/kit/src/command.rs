//! The commands of the kit: which package has which, and how each begins and ends.
//!
//! A package in scripts/ declares its commands in its manifest, so that all are known without building
//! any:
//!
//! ```toml
//! [package.metadata.lab]
//! title = "Measuring"     # the heading above its commands in the help
//! handout = true          # whether students get it too
//! commands = [["race", "Race programs against each other"]]
//! ```
//!
//! Exit codes, for scripts: 0 if all is well, 1 if the answer is no (a test failed, a file has drifted),
//! 2 if there was no answer (a bad command line, a missing file).

use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::{Command, Subcommand};
use serde::Deserialize;
use serde_json::Value;

use crate::files::read_toml_at;
use crate::kit::Kit;
use crate::page::folded;

/// A package behind the command.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Family {
    /// Its folder in the kit.
    #[serde(skip)]
    pub folder: String,
    /// The cargo package.
    #[serde(skip)]
    pub package: String,
    /// The heading above its commands.
    pub title: String,
    /// Whether students get it too.
    pub handout: bool,
    /// Names and what they do, in the order of the manifest; none of a library.
    pub commands: Vec<(String, String)>,
}

/// The packages behind the command that this copy of the kit has, in the order of the workspace's
/// members.
pub fn families(kit: &Kit) -> Result<Vec<Family>> {
    let members = read_toml_at(&kit.path("Cargo.toml"), "/workspace/members")?;
    let members: Vec<String> = members.context("the workspace has no members")?;
    let mut families = Vec::new();
    for folder in members {
        let manifest = kit.path(&folder).join("Cargo.toml");
        // A pattern of folders, such as labs/lab*, has none.
        if !manifest.is_file() {
            continue;
        }
        let name = read_toml_at(&manifest, "/package/name")?;
        let declared = read_toml_at::<Family>(&manifest, "/package/metadata/lab")?;
        families.extend(name.zip(declared).map(|(package, declared)| Family {
            folder,
            package,
            ..declared
        }));
    }
    Ok(families)
}

/// The command line of a package with commands `C`.
pub fn command_line<C: Subcommand>() -> Command {
    let line = Command::new("cargo lab").bin_name("cargo lab");
    C::augment_subcommands(line.subcommand_required(true).arg_required_else_help(true))
}

/// Reads the command line and runs a command in the kit around the current folder.
pub fn main<C: Subcommand>(run: impl FnOnce(&Kit, C) -> Result<ExitCode>) -> ExitCode {
    end_in_one_line();
    let command =
        C::from_arg_matches(&command_line::<C>().get_matches()).unwrap_or_else(|e| e.exit());
    finish(Kit::find().and_then(|kit| run(&kit, command)))
}

/// The exit code; an error is said in one line.
pub fn finish(result: Result<ExitCode>) -> ExitCode {
    result.unwrap_or_else(|error| {
        eprint!("{}", folded("error: ", &format!("{error:#}")));
        ExitCode::from(2)
    })
}

/// `head` and `less` close the pipe when they have seen enough: that is no error, and `println!` would panic. A full disk
/// behind standard output, and a thread that the system refuses, are errors in one line.
pub fn end_in_one_line() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let said = panic.payload_as_str().unwrap_or_default();
        let unprinted = said.strip_prefix("failed printing to stdout: ");
        if unprinted.is_some_and(|why| why.contains("Broken pipe")) {
            std::process::exit(0);
        }
        let refused = said.strip_prefix("failed to spawn thread: ");
        let lines = [
            unprinted.map(|why| format!("cannot write to standard output: {why}")),
            refused.map(|_| {
                "no thread could be started: raise the limit of this machine (ulimit -u)".into()
            }),
        ];
        if let Some(line) = lines.into_iter().flatten().next() {
            eprint!("{}", folded("error: ", &line));
            std::process::exit(2);
        }
        usual(panic);
    }));
}

/// For the tests of each package: its manifest and book/figures.toml say what its command line has.
///
/// # Panics
/// One of them says otherwise, or cannot be read.
pub fn expect_declared<C: Subcommand>(package: &str) {
    let faults = Kit::find().and_then(|kit| faults::<C>(&kit, package)).expect("the kit is whole");
    assert!(faults.is_empty(), "{faults:#?}");
}

/// In what they say otherwise: a line each.
fn faults<C: Subcommand>(kit: &Kit, package: &str) -> Result<Vec<String>> {
    let family = families(kit)?.into_iter().find(|family| family.package == package);
    let declared = family.with_context(|| format!("{package} declares no commands"))?.commands;
    let shown = |command: &Command| {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        (command.get_name().to_owned(), about)
    };
    let command = command_line::<C>();
    let here: Vec<_> = command.get_subcommands().filter(|c| !c.is_hide_set()).map(shown).collect();
    let mut faults = Vec::new();
    if declared != here {
        faults.push(format!("the manifest declares {declared:?}, the program has {here:?}"));
    }
    let figures = read_toml_at(&kit.path("book/figures.toml"), "/figure")?;
    let figures: Vec<Value> = figures.unwrap_or_default();
    for line in figures.iter().filter_map(|figure| figure.get("command")?.as_str()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(arguments) = words.strip_prefix(&["cargo", "lab"]) else { continue };
        if !declared.iter().any(|(name, _)| arguments.first() == Some(&&**name)) {
            continue;
        }
        if let Err(why) = command_line::<C>().try_get_matches_from([&["lab"], arguments].concat()) {
            faults.push(format!("book/figures.toml: '{line}': {why}"));
        }
    }
    Ok(faults)
}
