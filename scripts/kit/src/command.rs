//! Commands of the kit: finds the packages that contain them, starts them, and sets exit codes.
//!
//! A package in scripts/ declares its commands in its manifest, so that all commands are known
//! without building any package:
//!
//! ```toml
//! [package.metadata.lab]
//! title = "Measuring"     # the heading above its commands in the help
//! handout = true          # whether students get it too
//! commands = [["race", "Race programs against each other"]]
//! ```
//!
//! The exit code tells scripts the result. 0 means success. 1 means a negative result (a test
//! failed, a file has drifted). 2 means that there is no result (a bad command line, a missing
//! file).

use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::{Command, Subcommand};
use serde::Deserialize;
use serde_json::Value;

use crate::files::read_toml_at;
use crate::kit::Kit;
use crate::terminal::folded;

/// A package with commands.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Family {
    /// Folder of the package, in the kit.
    #[serde(skip)]
    pub folder: String,
    /// Name of the Cargo package.
    #[serde(skip)]
    pub package: String,
    /// Heading above the package's commands in the help.
    pub title: String,
    /// Whether students get the package too.
    pub handout: bool,
    /// Names and descriptions of the commands, in the order of the manifest; empty for a library.
    pub commands: Vec<(String, String)>,
}

/// Returns the packages with commands in this copy of the kit, in the order of the workspace's
/// members.
pub fn families(kit: &Kit) -> Result<Vec<Family>> {
    let members = read_toml_at(&kit.path("Cargo.toml"), "/workspace/members")?;
    let members: Vec<String> = members.context("the workspace has no members")?;
    let mut families = Vec::new();
    for folder in members {
        let manifest = kit.path(&folder).join("Cargo.toml");
        // A member may be a pattern of folders, such as labs/lab*, which has no manifest.
        if !manifest.is_file() {
            continue;
        }
        let name = read_toml_at(&manifest, "/package/name")?;
        let declared = read_toml_at::<Family>(&manifest, "/package/metadata/lab")?;
        let both = name.zip(declared);
        families.extend(both.map(|(package, family)| Family { folder, package, ..family }));
    }
    Ok(families)
}

/// Returns the command line of a package with commands `C`.
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

/// Returns the exit code; prints an error in one line.
pub fn finish(result: Result<ExitCode>) -> ExitCode {
    result.unwrap_or_else(|error| {
        eprint!("{}", folded("error: ", &format!("{error:#}")));
        ExitCode::from(2)
    })
}

/// Makes three kinds of panics end the program with at most one line.
///
/// `head` and `less` close the pipe early, which is not an error, but `println!` would panic. If
/// the disk of standard output is full, or the system refuses a thread, one line reports the error.
pub fn end_in_one_line() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let message = panic.payload_as_str().unwrap_or_default();
        let line = if let Some(why) = message.strip_prefix("failed printing to stdout: ") {
            if why.contains("Broken pipe") {
                std::process::exit(0);
            }
            format!("cannot write to standard output: {why}")
        } else if message.starts_with("failed to spawn thread: ") {
            "no thread could be started: raise the limit of this machine (ulimit -u)".into()
        } else {
            return usual(panic);
        };
        eprint!("{}", folded("error: ", &line));
        std::process::exit(2);
    }));
}

/// Asserts that a package's manifest and book/figures.toml agree with the package's command line.
///
/// Each package has a test that calls this function.
///
/// # Panics
/// If the files disagree with the command line, or cannot be read.
pub fn expect_declared<C: Subcommand>(package: &str) {
    let faults = Kit::find().and_then(|kit| faults::<C>(&kit, package)).expect("the kit is whole");
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Returns the differences, one per line.
fn faults<C: Subcommand>(kit: &Kit, package: &str) -> Result<Vec<String>> {
    let family = families(kit)?.into_iter().find(|family| family.package == package);
    let declared = family.with_context(|| format!("{package} declares no commands"))?.commands;
    let mut here = Vec::new();
    for command in command_line::<C>().get_subcommands().filter(|c| !c.is_hide_set()) {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        here.push((command.get_name().to_owned(), about));
    }
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
