//! Packs a student's submission: `labs/labN/src/**`.
//!
//! [`collect`] selects the files of a lab and gives a reason for each file that is left out.
//! [`pack`] makes the archive.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;
use flate2::{Compression, GzBuilder};

use crate::files::{files_below, is_left_by_a_tool};
use crate::kit::Kit;
use crate::lab::Lab;
use crate::starter::rename;

/// Maximal size of a single file, in bytes.
pub const FILE_LIMIT: u64 = 1 << 20;

/// Maximal number of files of a submission.
pub const COUNT_LIMIT: usize = 200;

/// Maximal length of a file's path below the lab's folder, in bytes.
const PATH_LIMIT: usize = 200;

/// Files by their path below the lab's folder, such as `src/lib.rs`.
pub type Sources = BTreeMap<String, Vec<u8>>;

/// Reason for leaving out a file that is not a regular file, such as a symbolic link.
pub const NOT_PLAIN: &str = "no plain file";

/// Reason for leaving out a file of more than [`FILE_LIMIT`] bytes.
pub const TOO_LARGE: &str = "more than 1 MiB";

/// Reason for leaving out a file whose path is not UTF-8. Such a path cannot equal any path of the
/// kit.
pub const NOT_UTF8: &str = "its name is not UTF-8";

/// Reason for leaving out a file that the system refuses to read.
const UNREADABLE: &str = "it cannot be read";

/// Extensions of the files that a lab's code consists of.
///
/// These files are Rust, shaders, and texts and tables that code includes.
const ENDINGS: [&str; 9] = [".rs", ".wgsl", ".csv", ".dat", ".in", ".json", ".md", ".toml", ".txt"];

/// Files of a lab: the submitted files, and the files that are left out.
#[derive(Debug, Default)]
pub struct Collected {
    /// Files that are submitted.
    pub files: Sources,
    /// Files that are left out, with the reasons.
    pub left_out: Vec<(PathBuf, &'static str)>,
}

/// Collects the sources below `folder/src`. Paths are relative to `folder`.
pub fn collect(folder: &Path) -> Result<Collected> {
    let mut collected = Collected::default();
    for path in files_below(&folder.join("src"))? {
        let relative = path.strip_prefix(folder)?.to_owned();
        let many = collected.files.len() >= COUNT_LIMIT;
        let read = if many { Err("more than 200 files") } else { read(&path, &relative) };
        match read {
            Ok((name, bytes)) => drop(collected.files.insert(name, bytes)),
            Err(why) => collected.left_out.push((relative, why)),
        }
    }
    Ok(collected)
}

/// Returns a file's name and bytes, or the reason for leaving it out.
fn read(path: &Path, relative: &Path) -> std::result::Result<(String, Vec<u8>), &'static str> {
    let name = relative.to_str().ok_or(NOT_UTF8)?;
    let metadata = fs::symlink_metadata(path).map_err(|_| UNREADABLE)?;
    match refused(name) {
        Some(why) => Err(why),
        None if !metadata.is_file() => Err(NOT_PLAIN),
        None if metadata.len() > FILE_LIMIT => Err(TOO_LARGE),
        None => Ok((name.to_owned(), fs::read(path).map_err(|_| UNREADABLE)?)),
    }
}

/// Returns the reason for leaving out a file because of its path; `None` if the path is accepted.
pub fn refused(path: &str) -> Option<&'static str> {
    if path.len() > PATH_LIMIT || path.contains(char::is_control) {
        return Some("its name is longer than 200 bytes, or holds a control character");
    }
    if path.split('/').any(is_left_by_a_tool) {
        return Some("hidden, or an editor's copy");
    }
    let is_known = ENDINGS.iter().any(|ending| path.ends_with(ending));
    (!is_known).then_some("its name does not end as that of a source does, such as .rs")
}

/// Packs the files as a `.tar.gz`. The same files give the same bytes, on every machine and at any
/// time.
pub fn pack(lab: Lab, files: &Sources) -> Result<Vec<u8>> {
    let zip = GzBuilder::new().mtime(0).operating_system(255);
    let mut archive = tar::Builder::new(zip.write(Vec::new(), Compression::best()));
    for (path, bytes) in files {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(0o644);
        header.set_mtime(0);
        header.set_entry_type(tar::EntryType::Regular);
        archive.append_data(&mut header, format!("labs/lab{lab}/{path}"), &bytes[..])?;
    }
    Ok(archive.into_inner()?.finish()?)
}

/// Returns the kit's own solution as a submission, under the lab's name.
pub fn of_solution(kit: &Kit, lab: Lab) -> Result<Sources> {
    let mut sources = collect(&kit.solution(lab))?.files;
    for (_, bytes) in sources.iter_mut().filter(|(path, _)| path.ends_with(".rs")) {
        *bytes = rename(&String::from_utf8_lossy(bytes), lab).into_bytes();
    }
    Ok(sources)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{collect, pack};

    #[test]
    fn the_same_files_give_the_same_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let lab = "1".parse().unwrap();
        let mut archives = Vec::new();
        for copy in ["a", "b"] {
            let src = folder.path().join(copy).join("src");
            fs::create_dir_all(&src).unwrap();
            fs::write(src.join("lib.rs"), "pub fn f() {}").unwrap();
            // Times and permissions must not matter.
            if copy == "b" {
                use std::os::unix::fs::PermissionsExt;
                let mode = fs::Permissions::from_mode(0o700);
                fs::set_permissions(src.join("lib.rs"), mode).unwrap();
            }
            archives.push(pack(lab, &collect(&folder.path().join(copy)).unwrap().files).unwrap());
        }
        assert_eq!(archives[0], archives[1]);
    }

    #[test]
    fn what_is_left_out_has_its_reason() {
        let folder = tempfile::tempdir().unwrap();
        let src = folder.path().join("src");
        fs::create_dir_all(&src).unwrap();
        fs::write(src.join("lib.rs"), "x").unwrap();
        fs::write(src.join(".secret"), "x").unwrap();
        fs::write(src.join("lib.rs~"), "x").unwrap();
        fs::write(src.join("big.rs"), vec![b' '; (super::FILE_LIMIT + 1) as usize]).unwrap();
        std::os::unix::fs::symlink("/etc/passwd", src.join("link.rs")).unwrap();
        fs::write(folder.path().join("Cargo.toml"), "x").unwrap();
        let collected = collect(folder.path()).unwrap();
        assert_eq!(collected.files.keys().collect::<Vec<_>>(), ["src/lib.rs"]);
        let left_out = collected.left_out.iter();
        let left_out: Vec<_> = left_out.map(|(path, why)| (path.to_str().unwrap(), *why)).collect();
        let expected = [
            ("src/.secret", "hidden, or an editor's copy"),
            ("src/big.rs", "more than 1 MiB"),
            ("src/lib.rs~", "hidden, or an editor's copy"),
            ("src/link.rs", "no plain file"),
        ];
        assert_eq!(left_out, expected);
    }
}
