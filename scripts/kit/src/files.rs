//! Finds, reads, writes, removes and compares files. Every error names the file.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use hmac_sha256::Hash;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Returns the message about a file or a folder that cannot be read.
fn unread(path: &Path) -> String {
    format!("cannot read {}", path.display())
}

/// Returns all files below a folder, sorted; empty if there is no such folder.
pub fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop().filter(|folder| folder.exists()) {
        for entry in fs::read_dir(&folder).with_context(|| unread(&folder))? {
            let entry = entry.with_context(|| unread(&folder))?;
            let is_folder = entry.file_type().with_context(|| unread(&folder))?.is_dir();
            if is_folder { &mut folders } else { &mut files }.push(entry.path());
        }
    }
    files.sort();
    Ok(files)
}

/// Returns the regular files below a folder, sorted, without files that tools leave there.
///
/// Such tools are, for example, editors and merges. A link counts as the file that it leads to.
/// Broken links, pipes and sockets are left out, because reading them fails or never ends.
pub fn sources_below(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = files_below(folder)?;
    files.retain(|path| {
        let below = path.strip_prefix(folder).unwrap_or(path);
        let is_left = below.iter().any(|part| is_left_by_a_tool(&part.to_string_lossy()));
        !is_left && fs::metadata(path).is_ok_and(|metadata| metadata.is_file())
    });
    Ok(files)
}

/// Ends of the names of copies that editors and merges leave beside a file.
const COPIES: [&str; 8] = ["~", "#", ".bak", ".orig", ".rej", ".swo", ".swp", ".tmp"];

/// Whether a file or a folder of this name is hidden, or is a copy that a tool left.
pub fn is_left_by_a_tool(name: &str) -> bool {
    name.starts_with('.') || COPIES.iter().any(|ending| name.ends_with(ending))
}

/// Reads a text file, with Unix line endings and without a byte order mark.
pub fn read_text(path: &Path) -> Result<String> {
    let text = fs::read_to_string(path).with_context(|| unread(path))?;
    Ok(text.trim_start_matches('\u{feff}').replace("\r\n", "\n"))
}

/// Converts a text to Unix line endings, so that texts can be compared. Other files are unchanged.
pub fn with_unix_lines(bytes: Vec<u8>) -> Vec<u8> {
    match String::from_utf8(bytes) {
        Ok(text) => text.replace("\r\n", "\n").into_bytes(),
        Err(other) => other.into_bytes(),
    }
}

/// Reads a TOML file.
pub fn read_toml<T: DeserializeOwned>(path: &Path) -> Result<T> {
    basic_toml::from_str(&read_text(path)?).with_context(|| unread(path))
}

/// Reads the value at a JSON pointer in a TOML file; `None` if there is no such value.
///
/// A JSON pointer is, for example, `/package/name`.
pub fn read_toml_at<T: DeserializeOwned>(path: &Path, pointer: &str) -> Result<Option<T>> {
    let mut all: Value = read_toml(path)?;
    let value = all.pointer_mut(pointer).map(Value::take).map(serde_json::from_value);
    value.transpose().with_context(|| format!("cannot read {pointer} of {}", path.display()))
}

/// Reads a file's bytes.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| unread(path))
}

/// Writes a file completely or not at all. Creates its folder if necessary.
pub fn write_file(path: &Path, contents: impl AsRef<[u8]>) -> Result<()> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written =
        folder.and_then(|()| common::write_whole(path, |out| out.write_all(contents.as_ref())));
    written.with_context(|| format!("cannot write {}", path.display()))
}

/// Writes a file, unless it has these contents already. So an unchanged file keeps its time.
pub fn write_changed(path: &Path, contents: &[u8]) -> Result<()> {
    if fs::read(path).is_ok_and(|there| there == contents) {
        return Ok(());
    }
    write_file(path, contents)
}

/// Removes a file.
pub fn remove_file(path: &Path) -> Result<()> {
    fs::remove_file(path).with_context(|| format!("cannot remove {}", path.display()))
}

/// Returns the SHA-256 of a file's contents, in hexadecimal digits.
pub fn digest(bytes: &[u8]) -> String {
    Hash::hash(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::os::unix::fs::symlink;
    use std::process::Command;

    use super::*;

    #[test]
    fn a_folder_is_made_for_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("figures/a.svg");
        write_file(&path, "text").unwrap();
        assert_eq!(read_text(&path).unwrap(), "text");
        assert_eq!(files_below(folder.path()).unwrap(), std::slice::from_ref(&path));
        let error = write_file(&path.join("below/a/file"), "text").unwrap_err();
        assert!(error.to_string().starts_with("cannot write"), "{error}");
    }

    #[test]
    fn only_regular_files_are_sources() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        for name in ["force.rs", "deep/own.rs", ".hidden.rs", "force.rs~", "#force.rs#", "a.rs.swp"]
        {
            write_file(&folder.join(name), "text").unwrap();
        }
        symlink("somebody@somewhere.4711", folder.join(".#force.rs")).unwrap();
        symlink("nowhere", folder.join("dangling.rs")).unwrap();
        symlink(folder.join("deep"), folder.join("around.rs")).unwrap();
        let mkfifo = Command::new("mkfifo").arg(folder.join("pipe.rs")).status().unwrap();
        assert!(mkfifo.success());
        let found = sources_below(folder).unwrap();
        assert_eq!(found, ["deep/own.rs", "force.rs"].map(|name| folder.join(name)));
    }

    #[test]
    fn a_list_that_cannot_be_read_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("list.toml");
        for text in [None, Some("n = 1, 2"), Some("n = 'one'")] {
            text.iter().for_each(|text| write_file(&path, text).unwrap());
            let error = read_toml::<BTreeMap<String, u8>>(&path).unwrap_err();
            assert!(error.to_string().ends_with("list.toml"), "{error}");
            let error = read_toml_at::<u8>(&path, "/n").unwrap_err();
            assert!(error.to_string().ends_with("list.toml"), "{error}");
        }
        write_file(&path, "n = 1").unwrap();
        assert_eq!(read_toml::<BTreeMap<String, u8>>(&path).unwrap()["n"], 1);
        assert_eq!(["/n", "/m"].map(|at| read_toml_at(&path, at).unwrap()), [Some(1), None]);
    }
}
