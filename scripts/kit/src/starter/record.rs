//! Record of the files that the tool wrote, so that it never overwrites a person's changes.
//!
//! Beside a starter there is `.starter`, with a line `hash  path` for each file, in the format of
//! `sha256sum`. This file is kept in the repository, so that the tool recognises its own files in a
//! fresh clone.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use super::generate::Files;
use crate::files::{digest, remove_file, with_unix_lines, write_file};

/// Hash of each file, by its path in the starter's folder.
#[derive(Debug, Default, PartialEq)]
pub struct Record(BTreeMap<PathBuf, String>);

/// Changes that turn a folder into a starter.
#[derive(Debug, Default, PartialEq)]
pub struct Plan {
    /// Files to write: new files, and the tool's own files that are out of date.
    pub write: Vec<PathBuf>,
    /// The tool's own files that the starter no longer has.
    pub remove: Vec<PathBuf>,
    /// Conflicting files that a person wrote or edited.
    pub edited: Vec<PathBuf>,
}

impl Plan {
    /// Writes and removes the files. Conflicting files stay.
    pub fn carry_out(&self, folder: &Path, files: &Files) -> Result<()> {
        for path in &self.write {
            write_file(&folder.join(path), &files[path])?;
        }
        self.remove.iter().try_for_each(|path| remove_file(&folder.join(path)))
    }
}

impl Record {
    /// Name of the record's file, beside the starter.
    pub const NAME: &str = ".starter";

    /// Makes the record of exactly these files.
    pub fn of(files: &Files) -> Self {
        Self(files.iter().map(|(path, bytes)| (path.clone(), hash(bytes.clone()))).collect())
    }

    /// Reads the record in a starter's folder; empty if there is none.
    pub fn read(folder: &Path) -> Result<Self> {
        let path = folder.join(Self::NAME);
        let text = match fs::read_to_string(&path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Self::default()),
            text => text.with_context(|| format!("cannot read {}", path.display()))?,
        };
        let mut record = BTreeMap::new();
        for (index, line) in text.lines().enumerate() {
            let Some((hash, file)) = line.split_once("  ") else {
                bail!("{}:{}: expected 'hash  path'", path.display(), index + 1);
            };
            record.insert(file.into(), hash.into());
        }
        Ok(Self(record))
    }

    /// Returns the text of the record's file.
    pub fn to_text(&self) -> String {
        self.0.iter().map(|(path, hash)| format!("{hash}  {}\n", path.display())).collect()
    }

    /// Writes the record into the folder.
    pub fn write(&self, folder: &Path) -> Result<()> {
        write_file(&folder.join(Self::NAME), self.to_text())
    }

    /// Returns the recorded paths.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.keys().map(PathBuf::as_path)
    }

    /// Whether the file at `path` in `folder` is unchanged since the tool wrote it.
    pub fn is_own(&self, folder: &Path, path: &Path) -> bool {
        let recorded = self.0.get(path);
        recorded.is_some() && recorded == fs::read(folder.join(path)).ok().map(hash).as_ref()
    }

    /// Plans the changes that turn `folder` into the starter `files`.
    pub fn plan(&self, folder: &Path, files: &Files) -> Plan {
        let mut plan = Plan::default();
        for (path, bytes) in files {
            let target = folder.join(path);
            if fs::read(&target).ok().as_ref() == Some(bytes) {
                continue;
            }
            let free = fs::symlink_metadata(&target).is_err() || self.is_own(folder, path);
            if free { &mut plan.write } else { &mut plan.edited }.push(path.clone());
        }
        for path in self.0.keys().filter(|path| !files.contains_key(*path)) {
            if self.is_own(folder, path) {
                plan.remove.push(path.clone());
            }
        }
        plan
    }
}

/// Returns the hash of a file. Line endings are normalised, because Git on Windows changes them.
fn hash(bytes: Vec<u8>) -> String {
    digest(&with_unix_lines(bytes))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::PathBuf;

    use super::{Plan, Record};
    use crate::starter::generate::Files;

    fn files(files: &[(&str, &str)]) -> Files {
        files.iter().map(|(path, text)| (path.into(), text.as_bytes().to_vec())).collect()
    }

    fn paths(paths: &[&str]) -> Vec<PathBuf> {
        paths.iter().map(PathBuf::from).collect()
    }

    #[test]
    fn only_own_output_is_replaced_or_removed() {
        let folder = tempfile::tempdir().unwrap();
        let old = files(&[
            ("kept", "1"),
            ("changed", "1"),
            ("edited", "1"),
            ("gone", "1"),
            ("gone_edited", "1"),
        ]);
        for (path, bytes) in &old {
            fs::write(folder.path().join(path), bytes).unwrap();
        }
        Record::of(&old).write(folder.path()).unwrap();
        for (path, text) in [("edited", "mine"), ("gone_edited", "mine"), ("unknown", "mine")] {
            fs::write(folder.path().join(path), text).unwrap();
        }
        let new = files(&[
            ("kept", "1"),
            ("changed", "2"),
            ("edited", "2"),
            ("unknown", "2"),
            ("new", "2"),
        ]);
        let plan = Record::read(folder.path()).unwrap().plan(folder.path(), &new);
        let expected = Plan {
            write: paths(&["changed", "new"]),
            remove: paths(&["gone"]),
            edited: paths(&["edited", "unknown"]),
        };
        assert_eq!(plan, expected);
    }

    #[test]
    fn a_file_that_is_right_already_is_in_nobodys_way() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("file"), "same").unwrap();
        let plan = Record::default().plan(folder.path(), &files(&[("file", "same")]));
        assert_eq!(plan, Plan::default());
    }

    #[test]
    fn line_endings_change_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let given = files(&[("file", "a\nb\n")]);
        fs::write(folder.path().join("file"), "a\r\nb\r\n").unwrap();
        let record = Record::of(&given);
        assert!(record.is_own(folder.path(), "file".as_ref()));
        assert_eq!(record, Record::of(&files(&[("file", "a\r\nb\r\n")])));
        fs::write(folder.path().join("file"), "a\r\nb \r\n").unwrap();
        assert!(!record.is_own(folder.path(), "file".as_ref()));
    }

    #[test]
    fn the_record_is_read_as_it_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let record = Record::of(&files(&[("src/lib.rs", "x"), ("src/with space.rs", "y")]));
        record.write(folder.path()).unwrap();
        assert_eq!(Record::read(folder.path()).unwrap(), record);
    }
}
