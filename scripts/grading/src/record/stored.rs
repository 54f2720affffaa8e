//! Records as files in a folder.

use std::fs::{self, DirEntry};
use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use super::{FORMAT, Record};
use lab_kit::Lab;
use lab_kit::escape::line;
use lab_kit::files::{read_bytes, write_file};

impl Record {
    /// Writes the record into a folder, under its name.
    pub(crate) fn write(&self, folder: &Path) -> Result<()> {
        let text = serde_json::to_string_pretty(self)?;
        write_file(&path(folder, &self.found.name), &text)
    }
}

/// Returns the path of a submission's record in a folder of records.
pub(crate) fn path(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.json"))
}

/// Reads a record from a file.
pub(crate) fn read(path: &Path) -> Result<Record> {
    let record: Record = serde_json::from_slice(&read_bytes(path)?)
        .with_context(|| format!("{} is no record", path.display()))?;
    ensure!(record.found.format == FORMAT, "{} is a record of another form", path.display());
    // The record's name must be the name of its file. Otherwise the name could be a path to any
    // folder, and the record would be written there.
    let own = path.file_name().is_some_and(|name| *name == *format!("{}.json", record.found.name));
    ensure!(
        own,
        "{} is the record of '{}': name it after that",
        path.display(),
        line(&record.found.name)
    );
    Ok(record)
}

/// Reads the records in a folder, sorted by name.
pub(crate) fn read_all(folder: &Path) -> Result<Vec<Record>> {
    let mut records =
        files(folder)?.iter().map(|path| read(path)).collect::<Result<Vec<Record>>>()?;
    sort(&mut records);
    Ok(records)
}

/// Checks that records of a lab can be written into a folder.
///
/// # Errors
/// If the folder contains records of a different lab.
pub(crate) fn expect_lab(folder: &Path, lab: Lab) -> Result<()> {
    if !folder.is_dir() {
        return Ok(());
    }
    // Records of a different format are skipped, because their submissions are graded again.
    for record in files(folder)?.iter().filter_map(|path| read(path).ok()) {
        let folder = folder.display();
        let other = record.found.lab;
        ensure!(other == lab, "{folder} holds records of lab {other}: name another folder");
    }
    Ok(())
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = entries.with_context(|| format!("cannot read {}", folder.display()))?;
    let mut files: Vec<PathBuf> = entries.iter().map(DirEntry::path).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    Ok(files)
}

/// Sorts records by their names.
pub(crate) fn sort(records: &mut [Record]) {
    records
        .sort_by_cached_key(|record| (record.found.name.to_lowercase(), record.found.name.clone()));
}

#[cfg(test)]
mod tests {
    use super::{Record, expect_lab, read_all};

    #[test]
    fn a_folder_holds_the_records_of_one_lab() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, [one, two]) = (folder.path(), ["1", "2"].map(|lab| lab.parse().unwrap()));
        expect_lab(&folder.join("none"), two).unwrap();
        Record::sample().write(folder).unwrap();
        expect_lab(folder, one).unwrap();
        let error = expect_lab(folder, two).unwrap_err().to_string();
        assert!(error.ends_with("holds records of lab 1: name another folder"), "{error}");
    }

    #[test]
    fn a_record_is_written_where_it_was_read() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        Record::sample().write(folder).unwrap();
        let text = std::fs::read_to_string(folder.join("ada.json")).unwrap();
        let elsewhere = text.replace("\"name\": \"ada\"", "\"name\": \"../ada\"");
        assert_ne!(text, elsewhere);
        std::fs::write(folder.join("ada.json"), elsewhere).unwrap();
        let error = read_all(folder).unwrap_err().to_string();
        assert!(
            error.ends_with("ada.json is the record of '../ada': name it after that"),
            "{error}"
        );
    }
}
