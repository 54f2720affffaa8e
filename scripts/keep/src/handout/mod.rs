//! `cargo lab handout`: the kit of a class, a tree that grows lab by lab.
//!
//! [`lay`] adds a lab to a tree: its starter, its tests, its chapter, and the answers of earlier
//! labs that it builds on. The tree contains neither the lab's solution nor a later one, and
//! nothing from `tests/wrong`. So a grader can build foreign code in such a tree without revealing
//! answers. A [`Record`] lists the files that nobody has changed since the command wrote them.
//! Edited files stay as they are. The tree is a git repository, with a commit for each lab.

mod book;
mod contents;
mod copied;
mod manifest;
mod repository;

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail, ensure};
use clap::Args;

use lab_kit::files::read_bytes;
use lab_kit::kit::listed;
use lab_kit::starter::Record;
use lab_kit::{Kit, Lab};
pub(crate) use manifest::fit;

/// Write a class's kit, or add a lab to it (for instructors)
///
/// The kit has the lab's starter, tests, hints and chapter, this command, and the solutions of
/// earlier labs that the lab builds on. It has no other solution, no known-wrong programs and no
/// instructor's pages. It is a git repository with a commit for each lab. Files that students have
/// edited stay as they are.
#[derive(Args)]
pub struct Options {
    /// The lab to add, such as 3; not a lab before the last one in the kit
    lab: Lab,
    /// The class's folder: new, empty, or written by this command
    #[arg(long, value_name = "DIR")]
    into: PathBuf,
    /// For a class with late days: let the lab build on the student's own earlier labs, and add
    /// none of their solutions. The next call without this option adds the solutions
    #[arg(long)]
    own: bool,
}

/// The earlier work that the labs of a tree build on.
#[derive(Clone, Copy, PartialEq)]
pub enum Earlier {
    /// The solutions of earlier labs.
    Solutions,
    /// The student's own work on the earlier labs that are in the tree.
    Own,
}

/// Writes or extends the tree, commits it, and prints its contents.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let Options { lab, into, own } = options;
    let laid = lay(kit, lab, &into, if own { Earlier::Own } else { Earlier::Solutions })?;
    let title = format!("Lab {lab}: {}", kit.title(lab));
    let committed = repository::commit(&into, &title, &laid.changed)?;
    let tree = Kit::at(&into);
    println!("{} is a class's kit{}:", into.display(), if committed { "" } else { ", as before" });
    println!("  labs         {}", listed(&tree.starters()));
    let solutions = tree.solutions();
    if !solutions.is_empty() {
        println!("  given code   the solutions of {}", listed(&solutions));
    }
    for path in laid.edited {
        println!("  left alone   {}, which somebody has edited", path.display());
    }
    println!("Look at it: cd {} && cargo lab test {lab}", into.display());
    Ok(ExitCode::SUCCESS)
}

/// The changes to a tree.
pub struct Laid {
    /// The files that were written or removed.
    pub changed: Vec<PathBuf>,
    /// The files that the command did not change, because somebody has edited them.
    pub edited: Vec<PathBuf>,
}

/// Adds `lab` to the tree in the folder `into`, which is made if it does not exist.
///
/// All contents are gathered before anything is written, so a kit that cannot be made leaves no
/// files behind.
///
/// # Errors
/// There is no such lab, `into` contains something other than such a tree, or a file cannot be read
/// or written.
pub fn lay(kit: &Kit, lab: Lab, into: &Path, earlier: Earlier) -> Result<Laid> {
    kit.chosen_solutions(Some(lab))?;
    let before = Record::read(into)?;
    let empty = fs::read_dir(into).map_or(!into.exists(), |mut there| there.next().is_none());
    let is_ours = before.paths().next().is_some();
    ensure!(empty || is_ours, "{} is there already and no class's kit", into.display());
    let mut labs = Kit::at(into).starters();
    if let Some(last) = labs.last().filter(|last| **last > lab) {
        bail!("lab {last} is there already, and may show the answers of lab {lab}");
    }
    labs.push(lab);
    labs.dedup();

    let mut files = contents::gather(kit, &labs, earlier)?;
    let plan = before.plan(into, &files);
    plan.carry_out(into, &files)?;
    let ours = files.keys().filter(|path| !plan.edited.contains(path));
    for script in ours.filter(|path| path.extension().is_some_and(|e| e == "sh")) {
        fs::set_permissions(into.join(script), fs::Permissions::from_mode(0o755))
            .with_context(|| format!("cannot make {} executable", script.display()))?;
    }
    // Cargo removes from the lock file the packages that only the kit needs, and leaves the other
    // packages at their versions. If that fails here, Cargo removes them at the first build.
    let _ = Kit::at(into).cargo().args(["update", "--workspace", "--offline"]).output();
    files.insert(LOCK.into(), read_bytes(&into.join(LOCK))?);
    let after = Record::of(&files);
    let mut changed = [plan.write, plan.remove].concat();
    if after == before {
        changed.clear();
    } else {
        after.write(into)?;
        changed.push(Record::NAME.into());
    }
    Ok(Laid { changed, edited: plan.edited })
}

const LOCK: &str = "Cargo.lock";

#[cfg(test)]
mod class_kits;
