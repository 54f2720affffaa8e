//! The copy of the kit that holds the mutated solutions: `target/prove/kit`.
//!
//! It is a workspace of its own, without starters, and its programs go to `target/prove/build`.
//! What it has in common with the kit, the packages from a registry, is compiled once for both. A file
//! that is right already is not touched, so that cargo compiles only what changed.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::handout::fit;
use lab_kit::files::{read_bytes, read_text, write_file};
use lab_kit::{Kit, Lab, files_below, sources_below};

/// The copy.
pub(crate) struct Copy {
    kit: Kit,
    /// Where its programs go: they have the names of the kit's own.
    programs: PathBuf,
    /// Where the kit is built.
    shared: PathBuf,
}

impl Copy {
    /// Makes the copy, with all solutions as they are but this lab's: its sources are the caller's.
    pub(crate) fn make(kit: &Kit, lab: Lab) -> Result<Self> {
        let copy = Self {
            kit: Kit::at(&kit.path("target/prove/kit")),
            programs: kit.path("target/prove/build"),
            shared: env::var_os("CARGO_TARGET_DIR")
                .map_or_else(|| kit.path("target"), |folder| kit.path(folder)),
        };
        let mut files = BTreeMap::new();
        let mutated = format!("solutions/lab{lab}/src");
        for folder in ["labs", "scripts", "solutions", "tests"] {
            for path in sources_below(&kit.path(folder))? {
                let relative = path.strip_prefix(kit.root())?.to_owned();
                if !is_left_out(&relative) {
                    files.insert(relative, path);
                }
            }
            for path in files_below(&copy.kit.path(folder))? {
                let relative = path.strip_prefix(copy.kit.root())?;
                if !files.contains_key(relative) {
                    fs::remove_file(&path)
                        .with_context(|| format!("cannot remove {}", path.display()))?;
                }
            }
        }
        for (relative, path) in files.iter().filter(|(relative, _)| !relative.starts_with(&mutated))
        {
            copy.put(relative, &read_bytes(path)?)?;
        }
        let paths = files.keys().map(PathBuf::as_path);
        // Another version: cargo would take a package of the copy for the kit's own, which is in the same folder
        // of its workspace, and then the kit's tests would run what the last proof has left.
        let manifest = fit(&read_text(&kit.path("Cargo.toml"))?, paths)?.replacen(
            "[workspace.package]\nversion = \"",
            "[workspace.package]\nversion = \"0.0.0-",
            1,
        );
        copy.put(Path::new("Cargo.toml"), manifest.as_bytes())?;
        copy.put(Path::new("Cargo.lock"), &read_bytes(&kit.path("Cargo.lock"))?)?;
        Ok(copy)
    }

    /// Writes a file, unless it is so already.
    pub(crate) fn put(&self, relative: &Path, bytes: &[u8]) -> Result<()> {
        let target = self.kit.path(relative);
        if fs::read(&target).is_ok_and(|there| there == bytes) {
            return Ok(());
        }
        write_file(&target, bytes)
    }

    /// Cargo, in the copy.
    pub(crate) fn cargo(&self) -> Command {
        let mut cargo = self.kit.cargo();
        cargo.env("CARGO_TARGET_DIR", &self.programs);
        cargo.env("CARGO_BUILD_BUILD_DIR", &self.shared);
        cargo
    }
}

/// Starters, wrong solutions, exam questions, which ask the tools, and what builds left behind.
fn is_left_out(relative: &Path) -> bool {
    let mut parts = relative.iter().filter_map(|part| part.to_str());
    let (top, second) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let is_starter =
        top == "labs" && second.strip_prefix("lab").is_some_and(|n| n.parse::<Lab>().is_ok());
    is_starter
        || (top == "tests" && ["wrong", "right", "exam"].contains(&second))
        || relative.iter().any(|part| part == "target")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::is_left_out;

    #[test]
    fn the_copy_has_what_solutions_need() {
        for (path, out) in [
            ("labs/common/src/lib.rs", false),
            ("labs/lab1/src/lib.rs", true),
            ("solutions/lab1/src/lib.rs", false),
            ("tests/lab1.rs", false),
            ("tests/snapshots/lab1__a.snap", false),
            ("tests/oracle/src/lib.rs", false),
            ("tests/wrong/lab1/a.rs", true),
            ("tests/exam/exam.rs", true),
        ] {
            assert_eq!(is_left_out(Path::new(path)), out, "{path}");
        }
    }
}
