//! Taking in what was handed in: foreign data, read into memory and never unpacked to a disk.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use super::names::{ARCHIVES, ELSEWHERE, is_macos, lab_of};
use super::{HandedIn, NAMED, archive};

/// The sources of each lab in a submission: a `.tar.gz`, a `.tar` or a `.zip`, or a folder, with labs/ in it
/// or one folder below, or with archives in it.
///
/// # Errors
/// It is neither, it is damaged, or it is larger than any submission.
pub(crate) fn read(path: &Path) -> Result<HandedIn> {
    let metadata = fs::symlink_metadata(path);
    let metadata = metadata.with_context(|| format!("cannot read {}", path.display()))?;
    if metadata.is_dir() {
        return folder(path);
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    ensure!(metadata.is_file(), "{name} is a link, or no plain file and no folder");
    let Some(unpack) = unpacker(path) else {
        bail!("{name} is neither a folder nor a .tar.gz or .zip: ask for one of these");
    };
    ensure!(metadata.len() > 0, "{name} is empty (0 bytes)");
    let packed = File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    unpack(packed).with_context(|| format!("{name} cannot be unpacked"))
}

type Unpack = fn(File) -> Result<HandedIn>;

/// What unpacks an archive, by its name; none if it is not called like one.
pub(super) fn unpacker(path: &Path) -> Option<Unpack> {
    let name = path.file_name()?.to_string_lossy();
    match *ARCHIVES.iter().find(|ending| name.ends_with(**ending))? {
        ".zip" => Some(archive::zip),
        ".tar" => Some(archive::tar),
        _ => Some(archive::tar_gz),
    }
}

fn folder(path: &Path) -> Result<HandedIn> {
    let mut tops = vec![path.to_owned()];
    if !path.join("labs").is_dir() {
        let entries = fs::read_dir(path)?.filter_map(|entry| Some(entry.ok()?.path()));
        let is_top =
            |top: &PathBuf| !top.is_symlink() && !is_macos(top) && top.join("labs").is_dir();
        tops = entries.filter(is_top).collect();
        ensure!(tops.len() < 2, "{} has labs/ in more than one folder", path.display());
    }
    let Some(top) = tops.first() else { return uploads(path) };
    let mut handed_in = HandedIn::default();
    walk(top, top, &mut handed_in)?;
    Ok(handed_in)
}

/// Takes what lies in a folder. It goes no deeper where no source of a lab can be.
fn walk(top: &Path, folder: &Path, handed_in: &mut HandedIn) -> Result<()> {
    let mut paths =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    paths.sort();
    for path in paths {
        let below = path.strip_prefix(top)?;
        let parts: Vec<_> = below.iter().map(|part| part.to_str().unwrap_or_default()).collect();
        let leads = match parts[..] {
            ["labs", lab, src, ..] => lab_of(lab).is_some() && src == "src",
            ["labs", lab] => lab_of(lab).is_some(),
            [only] => only == "labs",
            _ => false,
        };
        let metadata = fs::symlink_metadata(&path)?;
        if metadata.is_dir() && leads {
            walk(top, &path, handed_in)?;
        } else {
            let plain = metadata.is_file() || metadata.is_dir();
            handed_in.add(below, plain, metadata.len(), || File::open(&path))?;
        }
    }
    Ok(())
}

/// A folder for a student as learning platforms export it: what was uploaded lies in it, packed.
fn uploads(folder: &Path) -> Result<HandedIn> {
    let entries = fs::read_dir(folder)?.filter_map(|entry| Some(entry.ok()?.path()));
    let plain = |path: &Path| fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file());
    let (mut archives, others): (Vec<_>, Vec<_>) =
        entries.partition(|path| plain(path) && unpacker(path).is_some());
    archives.sort();
    let mut all = HandedIn::default();
    for archive in archives {
        let HandedIn { labs, left_out } = read(&archive)?;
        for (lab, files) in labs {
            let again = all.labs.insert(lab, files).is_some();
            ensure!(!again, "lab {lab} is in more than one archive in {}", folder.display());
        }
        all.left_out.extend(left_out);
    }
    for other in others.iter().filter(|other| !is_macos(other)) {
        all.left_out.push((other.strip_prefix(folder)?.to_owned(), ELSEWHERE));
    }
    all.left_out.truncate(NAMED);
    Ok(all)
}
