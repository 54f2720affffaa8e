//! Reads submissions. They are untrusted data, so they are read into memory and never unpacked to a
//! disk.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use super::archive;
use super::handed_in::{HandedIn, NAMED};
use super::names::{DEEP, is_built, is_called_archive, is_macos, lab_of};

/// Reads the sources of each lab in a submission.
///
/// A submission is an archive or a folder. It contains labs/ or archives in any place, or loose
/// files.
///
/// # Errors
/// If the file is neither, is damaged, or is too large for a submission.
pub(crate) fn read(path: &Path) -> Result<HandedIn> {
    let metadata = fs::symlink_metadata(path);
    let metadata = metadata.with_context(|| format!("cannot read {}", path.display()))?;
    if metadata.is_dir() {
        return folder(path);
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    ensure!(metadata.is_file(), "{name} is a link, or no plain file and no folder");
    let Some(unpack) = unpacker(path) else {
        bail!("{name} is neither a folder nor an archive: ask for a .tar.gz or .zip");
    };
    ensure!(metadata.len() > 0, "{name} is empty (0 bytes)");
    let packed = File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    unpack(packed).with_context(|| format!("{name} cannot be unpacked"))
}

type Unpack = fn(File) -> Result<HandedIn>;

/// Returns the function that unpacks a file; `None` if the file is no archive by content or name.
pub(super) fn unpacker(path: &Path) -> Option<Unpack> {
    let is_file = fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file());
    let head = is_file.then(|| archive::head(File::open(path).ok()?).ok()).flatten();
    let is_archive = head.is_some_and(|head| archive::is_archive(&head));
    (is_archive || is_called_archive(path)).then_some(archive::unpack as Unpack)
}

fn folder(path: &Path) -> Result<HandedIn> {
    let mut all = Below::default();
    find(path, 0, &mut all)?;
    ensure!(all.tops.len() < 2, "{} has labs/ in more than one folder", path.display());
    let Some(top) = all.tops.first() else { return uploads(path, all) };
    let mut handed_in = HandedIn::default();
    walk(top, top, &mut handed_in)?;
    Ok(handed_in)
}

/// Contents of a folder.
#[derive(Default)]
struct Below {
    /// Folders that contain labs/. They are not searched further.
    tops: Vec<PathBuf>,
    archives: Vec<PathBuf>,
    others: Vec<PathBuf>,
}

/// Lists the entries of a folder in the order of their names.
pub(super) fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut entries = entries.collect::<io::Result<Vec<_>>>()?;
    entries.sort();
    Ok(entries)
}

fn find(folder: &Path, depth: usize, all: &mut Below) -> Result<()> {
    let labs = fs::read_dir(folder.join("labs")).into_iter().flatten().flatten();
    if labs.into_iter().any(|entry| lab_of(&entry.file_name().to_string_lossy()).is_some()) {
        all.tops.push(folder.to_owned());
        return Ok(());
    }
    for path in entries(folder)?.into_iter().filter(|path| !is_macos(path)) {
        let metadata = fs::symlink_metadata(&path)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if metadata.is_dir() && depth < DEEP && !is_built(&name) {
            find(&path, depth + 1, all)?;
        } else if metadata.is_file() && unpacker(&path).is_some() {
            all.archives.push(path);
        } else {
            all.others.push(path);
        }
        let many = all.archives.len() + all.others.len() > archive::ENTRIES;
        ensure!(!many, "there are more than {} files in it", archive::ENTRIES);
    }
    Ok(())
}

/// Adds the files of a folder. It skips folders that cannot contain a lab's sources.
fn walk(top: &Path, folder: &Path, handed_in: &mut HandedIn) -> Result<()> {
    for path in entries(folder)? {
        let below = path.strip_prefix(top)?;
        let parts: Vec<_> = below.iter().map(|part| part.to_str().unwrap_or_default()).collect();
        let leads = match parts[..] {
            ["labs", lab, src, ..] => lab_of(lab).is_some() && src == "src",
            ["labs", lab] => lab_of(lab).is_some(),
            [only] => only == "labs",
            _ => false,
        };
        if leads && fs::symlink_metadata(&path)?.is_dir() {
            walk(top, &path, handed_in)?;
        } else {
            add(handed_in, &path, below)?;
        }
    }
    Ok(())
}

/// Adds a file with its path in the submission.
fn add(handed_in: &mut HandedIn, file: &Path, path: &Path) -> Result<u64> {
    let metadata = fs::symlink_metadata(file)?;
    let plain = metadata.is_file() || metadata.is_dir();
    handed_in.add(path, plain, metadata.len(), || File::open(file))
}

/// Reads a student's folder as learning platforms export it, with packed or loose uploads.
fn uploads(folder: &Path, below: Below) -> Result<HandedIn> {
    let mut all = HandedIn::default();
    for archive in below.archives {
        let HandedIn { labs, left_out, loose, .. } = read(&archive)?;
        for (lab, files) in labs {
            let again = all.labs.insert(lab, files).is_some();
            ensure!(!again, "lab {lab} is in more than one archive in {}", folder.display());
        }
        all.left_out.extend(left_out);
        all.loose.extend(loose);
    }
    for other in below.others {
        add(&mut all, &other, other.strip_prefix(folder)?)?;
    }
    all.left_out.truncate(NAMED);
    Ok(all)
}
