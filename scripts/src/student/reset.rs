//! `cargo lab reset`: a lab from the beginning, and nothing lost.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use crate::kit::{Kit, Lab};
use crate::starter;

/// Put a lab's starter back, and keep your work aside
///
/// What you wrote is moved to a folder of its own in kept/; nothing is deleted.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab
    lab: Lab,
}

/// Moves the sources aside and writes the starter.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let kept = set_aside(&kit.starter(lab).join("src"), &kit.path("kept"), &format!("lab{lab}"))?;
    starter::write(kit, lab)?;
    println!("Lab {lab} begins anew. Your work is in {}.", kept.display());
    Ok(ExitCode::SUCCESS)
}

/// Moves `folder` into `shelf` under the first free name `name-1`, `name-2`, …, and returns where.
fn set_aside(folder: &Path, shelf: &Path, name: &str) -> Result<PathBuf> {
    fs::create_dir_all(shelf).with_context(|| format!("cannot make {}", shelf.display()))?;
    let mut number = 1;
    let kept = loop {
        let kept = shelf.join(format!("{name}-{number}"));
        if !kept.exists() {
            break kept;
        }
        number += 1;
    };
    fs::rename(folder, &kept)
        .with_context(|| format!("cannot move {} to {}", folder.display(), kept.display()))?;
    Ok(kept)
}

#[cfg(test)]
mod tests {
    use super::set_aside;
    use std::fs;

    #[test]
    fn work_is_kept_and_no_earlier_work_is_overwritten() {
        let place = tempfile::tempdir().unwrap();
        let (src, shelf) = (place.path().join("src"), place.path().join("kept"));
        for work in ["first", "second"] {
            fs::create_dir(&src).unwrap();
            fs::write(src.join("lib.rs"), work).unwrap();
            let kept = set_aside(&src, &shelf, "lab3").unwrap();
            assert_eq!(fs::read_to_string(kept.join("lib.rs")).unwrap(), work);
            assert!(!src.exists());
        }
        assert_eq!(fs::read_to_string(shelf.join("lab3-1/lib.rs")).unwrap(), "first");
        assert_eq!(fs::read_to_string(shelf.join("lab3-2/lib.rs")).unwrap(), "second");
    }
}
