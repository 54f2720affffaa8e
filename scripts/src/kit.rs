//! Where the kit keeps its things.

use std::ffi::OsString;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::str::FromStr;

use anyhow::{Context, Result, ensure};
use serde::Serialize;

/// The folder that everything lies in.
#[derive(Clone, Debug)]
pub(crate) struct Kit {
    root: PathBuf,
}

/// The number of a lab, 1 or more. Read from `3` or `lab3`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(transparent)]
pub(crate) struct Lab(u8);

impl Kit {
    /// The kit around the current folder.
    pub(crate) fn find() -> Result<Self> {
        let here = std::env::current_dir().context("the current folder cannot be read")?;
        let root = here.ancestors().find(|folder| folder.join("labs/common/Cargo.toml").is_file());
        let root =
            root.context("this is not inside the kit: go to the folder that has labs/ in it")?;
        Ok(Self::at(root))
    }

    /// The kit in folder `root`.
    pub(crate) fn at(root: &Path) -> Self {
        Self { root: root.to_owned() }
    }

    /// The top folder.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// A path below the top folder.
    pub(crate) fn path(&self, relative: impl AsRef<Path>) -> PathBuf {
        self.root.join(relative)
    }

    /// What the student edits.
    pub(crate) fn starter(&self, lab: Lab) -> PathBuf {
        self.root.join(format!("labs/lab{lab}"))
    }

    /// The lab, solved.
    pub(crate) fn solution(&self, lab: Lab) -> PathBuf {
        self.root.join(format!("solutions/lab{lab}"))
    }

    /// What a lab is called, such as `all pairs`; its manifest says so.
    pub(crate) fn title(&self, lab: Lab) -> String {
        let manifest = fs::read_to_string(self.starter(lab).join("Cargo.toml")).unwrap_or_default();
        let line = manifest.lines().find(|line| line.starts_with("description"));
        let title =
            line.and_then(|line| line.split_once(", ")?.1.split_once(": ")).map(|(title, _)| title);
        title.unwrap_or("no title").into()
    }

    /// The chapter of a lab, below the top folder; none if it is not written.
    pub(crate) fn chapter(&self, lab: Lab) -> Option<String> {
        let chapter = format!("book/src/lab{lab}.md");
        self.root.join(&chapter).is_file().then_some(chapter)
    }

    /// A folder for what the tool remembers; not made yet.
    pub(crate) fn memory(&self) -> PathBuf {
        self.root.join("target/lab")
    }

    /// The labs that have a starter, in order.
    pub(crate) fn starters(&self) -> Result<Vec<Lab>> {
        labs_in(&self.root.join("labs"))
    }

    /// The labs that have a solution, in order.
    pub(crate) fn solutions(&self) -> Result<Vec<Lab>> {
        labs_in(&self.root.join("solutions"))
    }

    /// The labs that have a solution, or the one that is asked for.
    pub(crate) fn chosen_solutions(&self, lab: Option<Lab>) -> Result<Vec<Lab>> {
        let labs = self.solutions()?;
        let Some(lab) = lab else { return Ok(labs) };
        ensure!(labs.contains(&lab), "there is no solution of lab {lab} in this kit");
        Ok(vec![lab])
    }

    /// The sources of a lab's tests: tests/labN.rs and the files that it includes from tests/labN/; none
    /// if it has no tests.
    pub(crate) fn test_sources(&self, lab: Lab) -> Result<Vec<PathBuf>> {
        let source = self.path(format!("tests/lab{lab}.rs"));
        let included = files_below(&source.with_extension(""))?;
        Ok([source].into_iter().filter(|source| source.is_file()).chain(included).collect())
    }

    /// Refuses a lab that has no starter.
    pub(crate) fn expect_starter(&self, lab: Lab) -> Result<()> {
        ensure!(
            self.starter(lab).join("Cargo.toml").is_file(),
            "there is no lab {lab} here: labs/lab{lab} is missing (there are: {})",
            self.starters()?.iter().map(Lab::to_string).collect::<Vec<_>>().join(", ")
        );
        Ok(())
    }

    /// Cargo, the one that runs this command, in the top folder.
    pub(crate) fn cargo(&self) -> Command {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
        let mut command = Command::new(cargo);
        command.current_dir(&self.root);
        command
    }
}

fn labs_in(folder: &Path) -> Result<Vec<Lab>> {
    let mut labs = Vec::new();
    let entries = match fs::read_dir(folder) {
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(labs),
        entries => entries.with_context(|| format!("cannot read {}", folder.display()))?,
    };
    for entry in entries {
        let entry = entry?;
        let number =
            entry.file_name().to_str().and_then(|name| name.strip_prefix("lab")?.parse().ok());
        if let Some(lab) = number
            && entry.path().join("Cargo.toml").is_file()
        {
            labs.push(lab);
        }
    }
    labs.sort();
    Ok(labs)
}

impl Lab {
    /// The number, 1 or more.
    pub(crate) fn number(self) -> u8 {
        self.0
    }
}

impl fmt::Display for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl FromStr for Lab {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.strip_prefix("lab").unwrap_or(text).parse() {
            Ok(number) if number > 0 => Ok(Self(number)),
            _ => Err(format!("'{text}' is not the number of a lab, such as 3")),
        }
    }
}

/// All files below a folder, sorted; none if there is no such folder.
pub(crate) fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        if !folder.exists() {
            continue;
        }
        let unread = || format!("cannot read {}", folder.display());
        for entry in fs::read_dir(&folder).with_context(unread)? {
            let entry = entry.with_context(unread)?;
            if entry.file_type().with_context(unread)?.is_dir() {
                folders.push(entry.path());
            } else {
                files.push(entry.path());
            }
        }
    }
    files.sort();
    Ok(files)
}
