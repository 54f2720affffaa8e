//! Builds a lab as the grader does: with the files that would be handed in, and the kit's own.
//!
//! A workspace below `target/lab/graded` has links to everything in the kit except the lab itself.
//! The lab's package has a different name there. So Cargo compiles dependencies once for both
//! workspaces and does not confuse the two packages.

use std::fs;
use std::io;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use lab_kit::files::{read_text, write_changed};
use lab_kit::harness::{Build, BuildError, build};
use lab_kit::sources::{Collected, Sources};
use lab_kit::{Facts, Given, Kit, Lab};

use crate::test::visible_build;

/// A lab in a workspace for grading.
pub(crate) struct Graded {
    lab: Lab,
    tree: Kit,
    /// Build directory of the kit.
    target: PathBuf,
    /// Name of the lab's package in the workspace.
    package: String,
    /// Given files that the student changed. The kit's own versions are built.
    pub(crate) changed: Vec<String>,
}

impl Graded {
    /// Makes the workspace for a lab with these submitted files.
    pub(crate) fn lay(kit: &Kit, lab: Lab, collected: &Collected) -> Result<Self> {
        let given = Given::of(kit, lab)?;
        let mut files = collected.files.clone();
        let changed = given.put(&mut files);
        let package = format!("graded{lab}");
        for (path, mut bytes) in given.beside {
            if path == "Cargo.toml" {
                bytes = renamed(&String::from_utf8_lossy(&bytes), lab, &package).into_bytes();
            }
            files.insert(path, bytes);
        }
        let folder = kit.memory().join(format!("graded/lab{lab}"));
        lay(kit, lab, &files, &folder).context("the lab cannot be laid as it is graded")?;
        Ok(Self { lab, tree: Kit::at(&folder), target: kit.target(), package, changed })
    }

    /// Returns the order for building the lab's tests.
    pub(crate) fn tests(&self) -> Build {
        visible_build(self.cargo(), self.lab, self.package.clone())
    }

    /// Builds the lab; returns the message if that fails.
    pub(crate) fn trouble(&self) -> Option<String> {
        match build(self.tests()) {
            Ok(_) => None,
            Err(BuildError::Compile(_)) => Some(self.unbuilt()),
            Err(BuildError::Other(why)) => Some(format!("it could not be built here: {why}")),
        }
    }

    /// Returns the message about a lab that does not compile in the workspace.
    pub(crate) fn unbuilt(&self) -> String {
        let message = "it does not compile as the grader builds it";
        match &self.changed[..] {
            [] => message.to_owned(),
            changed => format!(
                "{message}, with the kit's own {}. Of yours it takes only the declarations of new files",
                changed.join(" and ")
            ),
        }
    }

    fn cargo(&self) -> Command {
        let mut cargo = self.tree.cargo();
        cargo.env("CARGO_TARGET_DIR", &self.target);
        // The grader builds in release mode. Only these two of its settings can change an answer,
        // and dependencies need not be built again for them.
        for setting in ["debug-assertions", "overflow-checks"] {
            cargo.arg("--config");
            cargo.arg(format!("profile.dev.package.{}.{setting}=false", self.package));
        }
        cargo
    }
}

/// Changes the package's name in the lab's manifest. The library keeps the lab's name.
fn renamed(manifest: &str, lab: Lab, package: &str) -> String {
    let name = format!("name = \"lab{lab}\"\n");
    let manifest = manifest.replacen(&name, &format!("name = \"{package}\"\n"), 1);
    let (head, tail) = manifest.split_once("[lib]\n").unwrap_or((&manifest, ""));
    format!("{head}\n[lib]\n{name}{tail}")
}

/// Writes the workspace. Files that are already right keep their times.
fn lay(kit: &Kit, lab: Lab, files: &Sources, folder: &Path) -> Result<()> {
    let own = format!("lab{lab}");
    let labs = folder.join("labs");
    fs::create_dir_all(labs.join(&own))?;
    let beside = ["README.md", Facts::FILE];
    link(kit.root(), folder, |name| ["scripts", "solutions", "tests"].contains(&name))?;
    link(&kit.path("labs"), &labs, |name| name != own && !name.starts_with('.'))?;
    link(&kit.starter(lab), &labs.join(&own), |name| beside.contains(&name))?;
    put(&folder.join("Cargo.toml"), read_text(&kit.path("Cargo.toml"))?.as_bytes())?;
    put(&folder.join("Cargo.lock"), read_text(&kit.path("Cargo.lock"))?.as_bytes())?;
    for old in lab_kit::files_below(&labs.join(&own))? {
        let below = old.strip_prefix(labs.join(&own))?.display().to_string();
        if !old.is_symlink() && !files.contains_key(&below) {
            fs::remove_file(&old)?;
        }
    }
    for (path, bytes) in files {
        put(&labs.join(&own).join(path), bytes)?;
    }
    Ok(())
}

fn put(path: &Path, bytes: &[u8]) -> Result<()> {
    if path.is_symlink() { Ok(()) } else { write_changed(path, bytes) }
}

/// Makes a link in `to` to everything in `from` whose name is `wanted`.
fn link(from: &Path, to: &Path, wanted: impl Fn(&str) -> bool) -> io::Result<()> {
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let link = to.join(entry.file_name());
        let is_wanted = wanted(&entry.file_name().to_string_lossy());
        if is_wanted && fs::read_link(&link).ok() != Some(entry.path()) {
            // An old link may lead into a kit that was moved.
            let _ = fs::remove_file(&link);
            symlink(entry.path(), link)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Graded;
    use lab_kit::files::write_file;
    use lab_kit::sources::collect;
    use lab_kit::{Kit, files_below};

    const MANIFEST: &str = "[package]\nname = \"lab1\"\nedition = \"2024\"\n";
    const TESTS: &str = "#[test]\nfn task() {\n    assert_eq!(lab1::task::f(), 1);\n}\n";

    /// Returns the message about a lab after replacing its given files by these.
    fn trouble(own: &[(&str, &str)]) -> Option<String> {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path().canonicalize().unwrap();
        let given = [
            ("Cargo.toml", MANIFEST),
            ("src/lib.rs", "pub mod task;\n"),
            ("src/task.rs", "pub fn f() -> u8 {\n    todo!(\"task 1.1: a number\")\n}\n"),
            ("tests/lab1.rs", TESTS),
        ];
        let workspace = "[workspace]\nmembers = [\"labs/lab*\"]\nresolver = \"3\"\n";
        let files = [("Cargo.toml", workspace), ("Cargo.lock", "version = 4\n")];
        let kit = Kit::of_files(&root, &files);
        let lab = "1".parse().unwrap();
        for (path, text) in given {
            write_file(&kit.starter(lab).join(".given").join(path), text).unwrap();
        }
        for (path, text) in given.iter().chain(own) {
            write_file(&kit.starter(lab).join(path), text).unwrap();
        }
        let before = files_below(&kit.starter(lab)).unwrap();
        let graded = Graded::lay(&kit, lab, &collect(&kit.starter(lab)).unwrap()).unwrap();
        let trouble = graded.trouble();
        assert_eq!(files_below(&kit.starter(lab)).unwrap(), before);
        trouble
    }

    #[test]
    fn what_the_grader_does_not_compile_is_not_well() {
        let message = "it does not compile as the grader builds it";
        let lib = "pub mod task;\npub fn g() -> u8 {\n    1\n}\n";
        let uses = "pub fn f() -> u8 {\n    crate::g()\n}\n";
        let why = trouble(&[("src/lib.rs", lib), ("src/task.rs", uses)]).unwrap();
        assert!(why.starts_with(&format!("{message}, with the kit's own src/lib.rs. Of")), "{why}");
        let hidden = [
            ("src/task.rs", "include!(\".own.rs\");\n"),
            ("src/.own.rs", "pub fn f() -> u8 { 1 }\n"),
        ];
        assert_eq!(trouble(&hidden).as_deref(), Some(message));
        let outside =
            [("src/task.rs", "include!(\"../own.rs\");\n"), ("own.rs", "pub fn f() -> u8 { 1 }\n")];
        assert_eq!(trouble(&outside).as_deref(), Some(message), "it is not handed in");
        let debug = "#[cfg(debug_assertions)]\npub fn f() -> u8 {\n    1\n}\n";
        assert_eq!(trouble(&[("src/task.rs", debug)]).as_deref(), Some(message));
    }

    #[test]
    fn new_modules_are_well_however_they_are_declared() {
        assert_eq!(trouble(&[]), None);
        let uses = ("src/task.rs", "pub fn f() -> u8 {\n    crate::own::g()\n}\n");
        let own = "pub fn g() -> u8 {\n    1\n}\n";
        for (lib, path) in [
            ("pub mod task;\nmod own; // a comment\n", "src/own.rs"),
            ("pub mod task; mod own;\n", "src/own/mod.rs"),
            ("pub mod task;\n#[path = \"target/x.rs\"]\nmod own;\n", "src/target/x.rs"),
        ] {
            assert_eq!(trouble(&[("src/lib.rs", lib), uses, (path, own)]), None, "{lib}");
        }
    }
}
