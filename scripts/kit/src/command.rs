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
use clap::{Command, CommandFactory, Parser};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::files::read_toml;
use crate::kit::Kit;

/// A package behind the command.
#[derive(Debug)]
pub struct Family {
    /// Its folder in the kit.
    pub folder: String,
    /// The cargo package.
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
///
/// # Errors
/// A manifest cannot be read.
pub fn families(kit: &Kit) -> Result<Vec<Family>> {
    let top: Top = manifest(kit, ".")?.context("there is no Cargo.toml")?;
    let mut families = Vec::new();
    for folder in top.workspace.members {
        let Some(Manifest { package }) = manifest(kit, &folder)? else { continue };
        if let Some(Declared { title, handout, commands }) = package.metadata.lab {
            families.push(Family { folder, package: package.name, title, handout, commands });
        }
    }
    Ok(families)
}

/// The manifest in a folder of the kit; none for a pattern of folders, such as labs/*.
fn manifest<M: DeserializeOwned>(kit: &Kit, folder: &str) -> Result<Option<M>> {
    let path = kit.path(folder).join("Cargo.toml");
    if !path.is_file() {
        return Ok(None);
    }
    read_toml(&path).map(Some)
}

#[derive(Deserialize)]
struct Top {
    workspace: Workspace,
}

#[derive(Deserialize)]
struct Workspace {
    members: Vec<String>,
}

#[derive(Deserialize)]
struct Manifest {
    package: Package,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    #[serde(default)]
    metadata: Metadata,
}

#[derive(Default, Deserialize)]
struct Metadata {
    lab: Option<Declared>,
}

#[derive(Deserialize)]
struct Declared {
    #[serde(default)]
    title: String,
    #[serde(default)]
    handout: bool,
    #[serde(default)]
    commands: Vec<(String, String)>,
}

/// Reads the command line and runs a command in the kit around the current folder.
pub fn main<O: Parser>(command: impl FnOnce(&Kit, O) -> Result<ExitCode>) -> ExitCode {
    end_quietly_when_nobody_reads();
    let options = O::parse();
    finish(Kit::find().and_then(|kit| command(&kit, options)))
}

/// The exit code; an error is said in one line.
pub fn finish(result: Result<ExitCode>) -> ExitCode {
    result.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::from(2)
    })
}

/// `head` and `less` close the pipe when they have seen enough: that is no error, and `println!`
/// would panic.
pub fn end_quietly_when_nobody_reads() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let said = panic.payload().downcast_ref::<String>();
        let unread = |text: &String| {
            text.starts_with("failed printing to stdout") && text.contains("Broken pipe")
        };
        if said.is_some_and(unread) {
            std::process::exit(0);
        }
        usual(panic);
    }));
}

/// For the tests of each package: its manifest and book/figures.toml say what its command line has.
///
/// # Panics
/// One of them says otherwise, or cannot be read.
pub fn expect_declared<O: CommandFactory>(package: &str) {
    let faults = Kit::find().and_then(|kit| faults::<O>(&kit, package)).expect("the kit is whole");
    assert!(faults.is_empty(), "{faults:#?}");
}

/// In what they say otherwise: a line each.
fn faults<O: CommandFactory>(kit: &Kit, package: &str) -> Result<Vec<String>> {
    let family = families(kit)?.into_iter().find(|family| family.package == package);
    let declared = family.with_context(|| format!("{package} declares no commands"))?.commands;
    let shown = |command: &Command| {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        (command.get_name().to_owned(), about)
    };
    let command = O::command();
    let here: Vec<_> = command.get_subcommands().filter(|c| !c.is_hide_set()).map(shown).collect();
    let mut faults = Vec::new();
    if declared != here {
        faults.push(format!("the manifest declares {declared:?}, the program has {here:?}"));
    }
    let figures: Figures = read_toml(&kit.path("book/figures.toml"))?;
    for line in figures.figure.iter().filter_map(|figure| figure.command.as_deref()) {
        let words: Vec<&str> = line.split_whitespace().take_while(|word| *word != "<").collect();
        let Some(arguments) = words.strip_prefix(&["cargo", "lab"]) else { continue };
        if !declared.iter().any(|(name, _)| arguments.first() == Some(&&**name)) {
            continue;
        }
        if let Err(why) = O::command().try_get_matches_from([&["lab"], arguments].concat()) {
            faults.push(format!("book/figures.toml: '{line}': {why}"));
        }
    }
    Ok(faults)
}

#[derive(Deserialize)]
struct Figures {
    figure: Vec<Figure>,
}

#[derive(Deserialize)]
struct Figure {
    command: Option<String>,
}
