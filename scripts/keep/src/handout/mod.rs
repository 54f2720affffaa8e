//! `cargo lab handout`: what a class gets, one tree that grows lab by lab.
//!
//! [`lay`] adds a lab to a tree: its starter, its tests, its chapter, and the answers of earlier labs that it builds
//! on. Nothing of its own solution or of a later one is in it, and nothing from `tests/wrong`: a grader who builds foreign
//! code in such a tree has nothing there to lose. [`record`](Record) says which files are as the command wrote them;
//! what somebody has edited since stays. The tree is a git repository, and each lab a commit.

mod book;
mod contents;
mod copied;
mod manifest;
mod repository;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail, ensure};
use clap::Args;

use lab_kit::files::{read_bytes, write_file};
use lab_kit::starter::Record;
use lab_kit::{Kit, Lab};
pub(crate) use manifest::fit;

/// Write a class's kit, or add a lab to it (for instructors)
///
/// It has the lab's starter, tests, hints and chapter, this command, and the solutions of earlier labs that the lab
/// builds on. It has no other solution, no known-wrong ones and no instructor's pages. It is a git repository: each
/// lab is a commit. What students have edited stays as it is.
#[derive(Args)]
pub struct Options {
    /// The lab to add, such as 3: none before the last one that is there
    lab: Lab,
    /// The class's folder: a new or an empty one, or one that this command wrote
    #[arg(long, value_name = "DIR")]
    into: PathBuf,
}

/// Writes or adds to the tree, commits, and says what is in it.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let Options { lab, into } = options;
    let laid = lay(kit, lab, &into)?;
    let title = format!("Lab {lab}: {}", kit.title(lab));
    let committed = repository::commit(&into, &title, &laid.changed)?;
    let tree = Kit::at(&into);
    let list = |labs: Vec<Lab>| labs.iter().map(Lab::to_string).collect::<Vec<_>>().join(", ");
    println!("{} is a class's kit{}:", into.display(), if committed { "" } else { ", as before" });
    println!("  labs         {}", list(tree.starters()));
    let solutions = tree.solutions();
    if !solutions.is_empty() {
        println!("  given code   the solutions of {}", list(solutions));
    }
    for path in laid.edited {
        println!("  left alone   {}, which somebody has edited", path.display());
    }
    println!("Look at it: cd {} && cargo lab test {lab}", into.display());
    Ok(ExitCode::SUCCESS)
}

/// What was done to a tree.
pub struct Laid {
    /// The files that were written or removed.
    pub changed: Vec<PathBuf>,
    /// Those that somebody has edited.
    pub edited: Vec<PathBuf>,
}

/// Adds `lab` to the tree in the folder `into`, which is made if it is not there.
///
/// # Errors
/// There is no such lab, `into` holds something else, or a file cannot be read or written. What is to
/// be written is gathered first: a kit that cannot be made leaves nothing behind.
pub fn lay(kit: &Kit, lab: Lab, into: &Path) -> Result<Laid> {
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

    let mut files = contents::gather(kit, &labs)?;
    let plan = before.plan(into, &files);
    for path in &plan.write {
        write(&into.join(path), &files[path])?;
    }
    for path in &plan.remove {
        let target = into.join(path);
        fs::remove_file(&target).with_context(|| format!("cannot remove {}", target.display()))?;
    }
    // What only the kit needs, cargo takes out of the lock file and leaves every version as it is. Where
    // it cannot, it does so at the first build.
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

/// Writes a file; one that is a script can be run.
fn write(target: &Path, bytes: &[u8]) -> Result<()> {
    write_file(target, bytes)?;
    #[cfg(unix)]
    if target.extension().is_some_and(|extension| extension == "sh") {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(target, fs::Permissions::from_mode(0o755))
            .with_context(|| format!("cannot write {}", target.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod class_kits;
