//! The kit's folders and files.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::facts::Facts;
use crate::files::{read_toml, read_toml_at, sources_below, write_file};
use crate::lab::Lab;

/// The top folder of a copy of the kit.
#[derive(Clone, Debug)]
pub struct Kit {
    root: PathBuf,
    /// Facts that have been read already.
    facts: Arc<Mutex<BTreeMap<Lab, Facts>>>,
}

impl Kit {
    /// Finds the kit around the current folder.
    pub fn find() -> Result<Self> {
        // All callers share the facts that have been read.
        static FOUND: OnceLock<Kit> = OnceLock::new();
        if let Some(kit) = FOUND.get() {
            return Ok(kit.clone());
        }
        let here = std::env::current_dir().context("the current folder cannot be read")?;
        let root = here.ancestors().find(|folder| folder.join("labs/common/Cargo.toml").is_file());
        let root =
            root.context("this is not inside the kit: go to the folder that has labs/ in it")?;
        Ok(FOUND.get_or_init(|| Self::at(root)).clone())
    }

    /// Returns the kit in folder `root`.
    pub fn at(root: &Path) -> Self {
        Self { root: root.to_owned(), facts: Arc::default() }
    }

    /// For tests: makes a kit in folder `root` with only these files, as paths and texts.
    ///
    /// # Panics
    /// If a file cannot be written.
    pub fn of_files(root: &Path, files: &[(&str, &str)]) -> Self {
        let kit = Self::at(root);
        for (path, text) in files {
            write_file(&kit.path(path), text).expect("a test may write its files");
        }
        kit
    }

    /// Returns the top folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Returns a path below the top folder.
    pub fn path(&self, relative: impl AsRef<Path>) -> PathBuf {
        self.root.join(relative)
    }

    /// Returns the folder of a lab's starter, which the student edits.
    pub fn starter(&self, lab: Lab) -> PathBuf {
        self.root.join(format!("labs/lab{lab}"))
    }

    /// Returns the folder of a lab's solution.
    pub fn solution(&self, lab: Lab) -> PathBuf {
        self.root.join(format!("solutions/lab{lab}"))
    }

    /// Reads the facts of a lab, from the solution's folder if the kit has it, or else the
    /// starter's.
    pub fn facts(&self, lab: Lab) -> Result<Facts> {
        let mut read = self.facts.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(facts) = read.get(&lab) {
            return Ok(facts.clone());
        }
        let file = self.facts_file(lab);
        let file = file.with_context(|| format!("there is no lab {lab} in this kit"))?;
        let facts: Facts = read_toml(&file).context("the lab's facts")?;
        read.insert(lab, facts.clone());
        Ok(facts)
    }

    /// Returns the file of a lab's facts; `None` if it has no facts.
    pub(crate) fn facts_file(&self, lab: Lab) -> Option<PathBuf> {
        let files = [self.solution(lab), self.starter(lab)].map(|folder| folder.join(Facts::FILE));
        files.into_iter().find(|file| file.is_file())
    }

    /// Returns the title of a lab, such as `all pairs`.
    pub fn title(&self, lab: Lab) -> String {
        self.facts(lab).map_or_else(|_| "no title".into(), |facts| facts.title)
    }

    /// Returns the path of a lab's chapter, below the top folder; `None` if there is no chapter
    /// yet.
    pub fn chapter(&self, lab: Lab) -> Option<String> {
        let chapter = format!("book/src/lab{lab}.md");
        self.root.join(&chapter).is_file().then_some(chapter)
    }

    /// Returns the folder for the tool's own files. It may not exist yet.
    pub fn memory(&self) -> PathBuf {
        self.root.join("target/lab")
    }

    /// Returns the build directory. It may not exist yet.
    pub fn target(&self) -> PathBuf {
        self.path(std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
    }

    /// Returns the labs that have a starter, in order.
    pub fn starters(&self) -> Vec<Lab> {
        labs_in(&self.root.join("labs"))
    }

    /// Returns the labs that have a solution, in order.
    pub fn solutions(&self) -> Vec<Lab> {
        labs_in(&self.root.join("solutions"))
    }

    /// Returns the labs that have a solution, or only `lab` if it is given.
    pub fn chosen_solutions(&self, lab: Option<Lab>) -> Result<Vec<Lab>> {
        let labs = self.solutions();
        let Some(lab) = lab else { return Ok(labs) };
        ensure!(labs.contains(&lab), "there is no solution of lab {lab} in this kit");
        Ok(vec![lab])
    }

    /// Returns the sources of a lab's tests; empty if it has no tests.
    ///
    /// The sources are tests/labN.rs and the files that this file includes from tests/labN/.
    pub fn test_sources(&self, lab: Lab) -> Result<Vec<PathBuf>> {
        let source = self.path(format!("tests/lab{lab}.rs"));
        let included = sources_below(&source.with_extension(""))?;
        Ok([source].into_iter().filter(|source| source.is_file()).chain(included).collect())
    }

    /// Returns the snapshots that a lab's tests compare with: tests/snapshots/labN__*.snap.
    pub fn snapshots(&self, lab: Lab) -> Result<Vec<PathBuf>> {
        let prefix = format!("lab{lab}__");
        let mut snapshots = sources_below(&self.path("tests/snapshots"))?;
        snapshots.retain(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(&prefix) && name.ends_with(".snap")
        });
        Ok(snapshots)
    }

    /// Returns the folders of the kit's own packages that the package in `folder` depends on.
    ///
    /// The folders are relative to the top folder.
    pub fn dependencies(&self, folder: &Path) -> Result<Vec<String>> {
        let named = table(folder, "/dependencies")?;
        let all = table(&self.root, "/workspace/dependencies")?;
        let paths = named.keys().filter_map(|name| all.get(name)?.get("path")?.as_str());
        Ok(paths.map(String::from).collect())
    }

    /// Returns an error if a lab has no starter.
    pub fn expect_starter(&self, lab: Lab) -> Result<()> {
        ensure!(
            self.starter(lab).join("Cargo.toml").is_file(),
            "there is no lab {lab} here: labs/lab{lab} is missing (there are: {})",
            listed(&self.starters())
        );
        Ok(())
    }

    /// Returns a Cargo command in the top folder, with the Cargo that runs this program.
    pub fn cargo(&self) -> Command {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
        let mut command = Command::new(cargo);
        command.current_dir(&self.root);
        command
    }
}

/// Reads a table of the manifest in a folder; empty if there is no such table.
fn table(folder: &Path, pointer: &str) -> Result<BTreeMap<String, Value>> {
    Ok(read_toml_at(&folder.join("Cargo.toml"), pointer)?.unwrap_or_default())
}

/// Lists labs as `1, 2, 5`.
pub fn listed(labs: &[Lab]) -> String {
    labs.iter().map(Lab::to_string).collect::<Vec<_>>().join(", ")
}

fn labs_in(folder: &Path) -> Vec<Lab> {
    let labs = (1..=u8::MAX).filter_map(|number| number.to_string().parse().ok());
    labs.filter(|lab| folder.join(format!("lab{lab}/Cargo.toml")).is_file()).collect()
}
