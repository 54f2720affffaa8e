//! `cargo lab reset`: puts the starter of a lab back.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use lab_kit::files::{remove_file, write_file};
use lab_kit::machine::date;
use lab_kit::starter::{Files, Record, given, own_files};
use lab_kit::{Kit, Lab};

/// Folder for kept work. It is not under `target/`, because `cargo clean` empties that.
const KEPT: &str = "kept";

/// Start a lab again; your work so far is kept
///
/// Copies src/, tests/ and Cargo.toml of the lab to a new folder in kept/, then replaces them by
/// the starter's. Hints that you have seen still count as seen.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 1
    lab: Lab,
}

/// Keeps the work and puts the starter back.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    kit.expect_starter(lab)?;
    match reset(kit, lab)? {
        None => println!("Lab {lab} is as it was given: there is nothing to reset."),
        Some(kept) => {
            println!("Lab {lab} is as it was given. Your work is kept in {}.", kept.display());
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Resets a lab. Returns the folder of the kept work, below the top folder; `None` if there was no
/// work.
fn reset(kit: &Kit, lab: Lab) -> Result<Option<PathBuf>> {
    let folder = kit.starter(lab);
    let given = given(kit, lab)?;
    let there = own_files(&folder)?;
    if there == given {
        return Ok(None);
    }
    let kept = keep(kit, lab, &there)
        .with_context(|| format!("your work cannot be kept in {KEPT}/, so nothing was changed"))?;
    put_back(&folder, &there, &given).with_context(|| {
        format!("lab {lab} is reset in part; your work is kept in {}", kept.display())
    })?;
    Ok(Some(kept))
}

/// Replaces the files that are `there` by the given files.
fn put_back(folder: &Path, there: &Files, given: &Files) -> Result<()> {
    for (path, bytes) in given.iter().filter(|(path, bytes)| there.get(*path) != Some(bytes)) {
        write_file(&folder.join(path), bytes)?;
    }
    for path in there.keys().filter(|path| !given.contains_key(*path)) {
        remove_file(&folder.join(path))?;
    }
    Record::of(given).write(folder)
}

/// Writes the files, all or none, to a new folder.
fn keep(kit: &Kit, lab: Lab, files: &Files) -> Result<PathBuf> {
    let all_kept = kit.path(KEPT);
    fs::create_dir_all(&all_kept)?;
    let copy = tempfile::tempdir_in(&all_kept)?;
    for (path, bytes) in files {
        write_file(&copy.path().join(path), bytes)?;
    }
    let name = format!("lab{lab}-{}", date());
    let names = (1..).map(|time| match time {
        1 => name.clone(),
        time => format!("{name}-{time}"),
    });
    let free = names.map(|name| Path::new(KEPT).join(name)).find(|path| !kit.path(path).exists());
    let free = free.context("no name is free")?;
    fs::rename(copy.path(), kit.path(&free))?;
    Ok(free)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::reset;
    use lab_kit::Kit;
    use lab_kit::files::write_file;
    use lab_kit::starter::{Record, generate};

    const SOLUTION: &str = "\
pub fn f() -> u8 {
    // task 1.1: a number
    42
    // end 1.1
}
";

    /// Makes a kit with only lab 1 and its starter.
    fn kit(root: &Path) -> Kit {
        let manifest = "[package]\nname = \"solution1\"\n\n[lints]\nworkspace = true\n";
        let files = [
            ("Cargo.toml", "[workspace]\n"),
            ("solutions/lab1/Cargo.toml", manifest),
            ("solutions/lab1/src/lib.rs", SOLUTION),
            ("labs/lab1/notes.md", "hints"),
        ];
        let kit = Kit::of_files(root, &files);
        let lab = "1".parse().unwrap();
        let given = generate(&kit, lab).unwrap();
        for (path, bytes) in &given {
            write_file(&kit.starter(lab).join(path), bytes).unwrap();
        }
        Record::of(&given).write(&kit.starter(lab)).unwrap();
        kit
    }

    #[test]
    fn work_is_kept_and_the_starter_is_back() {
        let folder = tempfile::tempdir().unwrap();
        let kit = kit(folder.path());
        let lab = "1".parse().unwrap();
        let starter = fs::read(kit.path("labs/lab1/src/lib.rs")).unwrap();
        fs::write(kit.path("labs/lab1/src/lib.rs"), "mine").unwrap();
        write_file(&kit.path("labs/lab1/src/deep/own.rs"), "my own").unwrap();

        let kept = kit.path(reset(&kit, lab).unwrap().unwrap());
        assert_eq!(fs::read(kept.join("src/lib.rs")).unwrap(), b"mine");
        assert_eq!(fs::read(kept.join("src/deep/own.rs")).unwrap(), b"my own");
        assert!(kept.join("Cargo.toml").is_file());
        assert_eq!(fs::read(kit.path("labs/lab1/src/lib.rs")).unwrap(), starter);
        assert!(!kit.path("labs/lab1/src/deep/own.rs").exists());
        assert!(kit.path("labs/lab1/notes.md").is_file());
        assert_eq!(reset(&kit, lab).unwrap(), None, "nothing is left to reset");
    }

    #[test]
    fn line_endings_are_no_work() {
        let folder = tempfile::tempdir().unwrap();
        let kit = kit(folder.path());
        let lab = "1".parse().unwrap();
        // A clone made on Windows has these line endings, in the solution too.
        for folder in ["labs/lab1", "solutions/lab1"] {
            for path in ["src/lib.rs", "Cargo.toml"].map(|path| kit.path(folder).join(path)) {
                let text = fs::read_to_string(&path).unwrap();
                fs::write(&path, text.replace('\n', "\r\n")).unwrap();
            }
        }
        assert_eq!(reset(&kit, lab).unwrap(), None);
        fs::write(kit.path("labs/lab1/src/lib.rs"), "mine\r\n").unwrap();
        assert!(reset(&kit, lab).unwrap().is_some());
    }

    #[test]
    fn what_was_kept_before_stays() {
        let folder = tempfile::tempdir().unwrap();
        let kit = kit(folder.path());
        let mut all_kept = Vec::new();
        for text in ["first", "second"] {
            fs::write(kit.path("labs/lab1/src/lib.rs"), text).unwrap();
            all_kept.push(kit.path(reset(&kit, "1".parse().unwrap()).unwrap().unwrap()));
        }
        for (kept, text) in all_kept.iter().zip(["first", "second"]) {
            assert_eq!(fs::read_to_string(kept.join("src/lib.rs")).unwrap(), text);
        }
    }

    #[test]
    fn a_kit_without_the_solution_has_the_starter_aside() {
        let folder = tempfile::tempdir().unwrap();
        let kit = kit(folder.path());
        let lab = "1".parse().unwrap();
        for (path, bytes) in generate(&kit, lab).unwrap() {
            let target = kit.starter(lab).join(lab_kit::starter::GIVEN).join(path);
            write_file(&target, bytes).unwrap();
        }
        let starter = fs::read(kit.path("labs/lab1/src/lib.rs")).unwrap();
        fs::remove_dir_all(kit.path("solutions")).unwrap();
        fs::write(kit.path("labs/lab1/src/lib.rs"), "mine").unwrap();
        assert!(reset(&kit, lab).unwrap().is_some());
        assert_eq!(fs::read(kit.path("labs/lab1/src/lib.rs")).unwrap(), starter);
        assert_eq!(reset(&kit, lab).unwrap(), None);
    }

    #[test]
    fn what_cannot_be_kept_is_not_touched() {
        let folder = tempfile::tempdir().unwrap();
        let kit = kit(folder.path());
        fs::write(kit.path("labs/lab1/src/lib.rs"), "mine").unwrap();
        fs::write(kit.path("kept"), "a file where a folder belongs").unwrap();
        reset(&kit, "1".parse().unwrap()).unwrap_err();
        assert_eq!(fs::read(kit.path("labs/lab1/src/lib.rs")).unwrap(), b"mine");
    }
}
