//! Copy of the kit with the mutated solutions: `target/prove/kit`.
//!
//! It is a separate workspace without starters, and its programs go to `target/prove/build`.
//! Packages from a registry are compiled once for the kit and the copy. A file that is already
//! right is not written again, so that Cargo compiles only the changes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::handout::fit;
use lab_kit::files::{read_bytes, read_text, remove_file, write_changed};
use lab_kit::{Kit, Lab, files_below, sources_below};

/// A copy of the kit.
pub(crate) struct Copy {
    kit: Kit,
    /// Folder of the copy's programs, which have the same names as the kit's own.
    programs: PathBuf,
    /// Build directory of the kit.
    shared: PathBuf,
}

impl Copy {
    /// Makes the copy, with all solutions unchanged except this lab's, whose sources the caller
    /// writes.
    pub(crate) fn make(kit: &Kit, lab: Lab) -> Result<Self> {
        let copy = Self {
            kit: Kit::at(&kit.path("target/prove/kit")),
            programs: kit.path("target/prove/build"),
            shared: kit.target(),
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
                    remove_file(&path)?;
                }
            }
        }
        for (relative, path) in files.iter().filter(|(relative, _)| !relative.starts_with(&mutated))
        {
            copy.put(relative, &read_bytes(path)?)?;
        }
        let paths = files.keys().map(PathBuf::as_path);
        // The copy has a different version, because its packages are in the same folders of a
        // workspace as the kit's. Otherwise Cargo would confuse them, and the kit's tests would run
        // programs that the last proof left.
        let manifest = fit(&read_text(&kit.path("Cargo.toml"))?, paths)?.replacen(
            "[workspace.package]\nversion = \"",
            "[workspace.package]\nversion = \"0.0.0-",
            1,
        );
        copy.put(Path::new("Cargo.toml"), manifest.as_bytes())?;
        copy.put(Path::new("Cargo.lock"), &read_bytes(&kit.path("Cargo.lock"))?)?;
        Ok(copy)
    }

    /// Writes a file, unless it has these contents already.
    pub(crate) fn put(&self, relative: &Path, bytes: &[u8]) -> Result<()> {
        write_changed(&self.kit.path(relative), bytes)
    }

    /// Returns a Cargo command in the copy.
    pub(crate) fn cargo(&self) -> Command {
        let mut cargo = self.kit.cargo();
        cargo.env("CARGO_TARGET_DIR", &self.programs);
        cargo.env("CARGO_BUILD_BUILD_DIR", &self.shared);
        cargo
    }
}

/// Whether a path is not copied.
///
/// These are starters, wrong solutions, right variants, and the output of builds.
fn is_left_out(relative: &Path) -> bool {
    let mut parts = relative.iter().filter_map(|part| part.to_str());
    let top = parts.next().unwrap_or_default();
    let second = parts.next().unwrap_or_default();
    let is_starter =
        top == "labs" && second.strip_prefix("lab").is_some_and(|n| n.parse::<Lab>().is_ok());
    is_starter
        || (top == "tests" && ["wrong", "right"].contains(&second))
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
            ("tests/right/lab1/a.rs", true),
        ] {
            assert_eq!(is_left_out(Path::new(path)), out, "{path}");
        }
    }
}
