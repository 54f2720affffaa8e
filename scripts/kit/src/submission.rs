//! What a student hands in: `labs/labN/src/**`, packed.
//!
//! [`collect`] says which files of a lab go in and why others do not, [`pack`] makes the archive.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use flate2::{Compression, GzBuilder};

use crate::files::files_below;
use crate::kit::Kit;
use crate::lab::Lab;
use crate::starter::rename;

/// The most bytes of a single file.
pub const FILE_LIMIT: u64 = 1 << 20;

/// The most files of a submission.
pub const COUNT_LIMIT: usize = 200;

/// The most bytes of a file's path below the lab's folder.
const PATH_LIMIT: usize = 200;

/// Files by their path below the lab's folder, such as `src/lib.rs`.
pub type Sources = BTreeMap<String, Vec<u8>>;

/// Why a file is not taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOut {
    /// It is no plain file, such as a symbolic link.
    NotPlain,
    /// Its name begins with a dot or ends as editors' copies do.
    Hidden,
    /// Its name is not UTF-8.
    Name,
    /// Its path is longer than any source's, or has a character that no name of a source has.
    Unfit,
    /// It has more than [`FILE_LIMIT`] bytes.
    TooLarge,
    /// There are [`COUNT_LIMIT`] files already.
    TooMany,
    /// It is no source of a lab.
    Elsewhere,
    /// Its path leads out of the submission.
    Outside,
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotPlain => "no plain file",
            Self::Hidden => "hidden, or an editor's copy",
            Self::Name => "its name is not UTF-8",
            Self::Unfit => "its name is longer than 200 bytes, or holds a control character",
            Self::TooLarge => "more than 1 MiB",
            Self::TooMany => "more than 200 files",
            Self::Elsewhere => "not below labs/labN/src: grading has its own",
            Self::Outside => "its path leads out of the submission",
        })
    }
}

/// A lab's files: what is taken, and what is not.
#[derive(Debug, Default)]
pub struct Collected {
    /// What is taken.
    pub files: Sources,
    /// What is not.
    pub left_out: Vec<(PathBuf, LeftOut)>,
}

/// Collects the sources below `folder/src`; paths are below `folder`.
pub fn collect(folder: &Path) -> Result<Collected> {
    let mut collected = Collected::default();
    for path in files_below(&folder.join("src"))? {
        let unread = || format!("cannot read {}", path.display());
        let relative = path.strip_prefix(folder)?.to_owned();
        let metadata = fs::symlink_metadata(&path).with_context(unread)?;
        let name = relative.to_str().map(String::from);
        let why = if !metadata.is_file() {
            Some(LeftOut::NotPlain)
        } else if metadata.len() > FILE_LIMIT {
            Some(LeftOut::TooLarge)
        } else {
            name.as_deref().map_or(Some(LeftOut::Name), refused)
        };
        let why = why.or((collected.files.len() >= COUNT_LIMIT).then_some(LeftOut::TooMany));
        match (why, name) {
            (None, Some(name)) => {
                collected.files.insert(name, fs::read(&path).with_context(unread)?);
            }
            (why, _) => collected.left_out.push((relative, why.unwrap_or(LeftOut::Name))),
        }
    }
    Ok(collected)
}

/// Whether a path's name alone keeps it out.
pub fn refused(path: &str) -> Option<LeftOut> {
    let hidden = |part: &str| {
        part.starts_with('.') || part.ends_with('~') || part.ends_with(".bak") || part == "target"
    };
    if path.len() > PATH_LIMIT || path.contains(char::is_control) {
        return Some(LeftOut::Unfit);
    }
    path.split('/').any(hidden).then_some(LeftOut::Hidden)
}

/// The archive, a `.tar.gz`: the same files give the same bytes, on each machine and at each time.
pub fn pack(lab: Lab, files: &Sources) -> Result<Vec<u8>> {
    let zip = GzBuilder::new().mtime(0).operating_system(255);
    let mut archive = tar::Builder::new(zip.write(Vec::new(), Compression::best()));
    for (path, bytes) in files {
        append(&mut archive, &format!("labs/lab{lab}/{path}"), bytes)?;
    }
    Ok(archive.into_inner()?.finish()?)
}

fn append(archive: &mut tar::Builder<impl Write>, path: &str, bytes: &[u8]) -> io::Result<()> {
    let mut header = tar::Header::new_gnu();
    header.set_size(bytes.len() as u64);
    header.set_mode(0o644);
    header.set_mtime(0);
    header.set_entry_type(tar::EntryType::Regular);
    archive.append_data(&mut header, path, bytes)
}

/// The kit's own solution as if it had been handed in: under the lab's name.
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

    use super::{LeftOut, collect, pack};

    #[test]
    fn the_same_files_give_the_same_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let lab = "1".parse().unwrap();
        let mut archives = Vec::new();
        for copy in ["a", "b"] {
            let src = folder.path().join(copy).join("src");
            fs::create_dir_all(&src).unwrap();
            fs::write(src.join("lib.rs"), "pub fn f() {}").unwrap();
            // Times and permissions are nobody's business.
            #[cfg(unix)]
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
    #[cfg(unix)]
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
        assert_eq!(
            left_out,
            [
                ("src/.secret", LeftOut::Hidden),
                ("src/big.rs", LeftOut::TooLarge),
                ("src/lib.rs~", LeftOut::Hidden),
                ("src/link.rs", LeftOut::NotPlain),
            ]
        );
    }
}
