//! Taking in what was handed in: foreign data, read into memory and never unpacked to a disk.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use super::names::ARCHIVES;
use super::path::lab_of;
use super::{HandedIn, NAMED, archive};
use lab_kit::submission::{LeftOut, collect};

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
    let linked = |path: &Path| fs::symlink_metadata(path).is_ok_and(|m| m.is_symlink());
    let mut tops = vec![path.to_owned()];
    if !path.join("labs").is_dir() {
        let entries = fs::read_dir(path)?.filter_map(|entry| Some(entry.ok()?.path()));
        tops = entries.filter(|top| !linked(top) && top.join("labs").is_dir()).collect();
        ensure!(tops.len() < 2, "{} has labs/ in more than one folder", path.display());
        if tops.is_empty() {
            return uploads(path);
        }
    }
    let mut handed_in = HandedIn::default();
    for top in tops {
        ensure!(!linked(&top.join("labs")), "labs/ in it is a symbolic link");
        handed_in.left_out.extend(others(&top, &top, "labs")?);
        for entry in fs::read_dir(top.join("labs"))? {
            let entry = entry?;
            let lab_folder = entry.path();
            let relative = lab_folder.strip_prefix(&top).unwrap_or(&lab_folder).to_owned();
            let Some(lab) = entry.file_name().to_str().and_then(lab_of) else {
                handed_in.left_out.push((relative, LeftOut::Elsewhere));
                continue;
            };
            if linked(&lab_folder) || linked(&lab_folder.join("src")) {
                handed_in.left_out.push((relative.join("src"), LeftOut::NotPlain));
                continue;
            }
            if !lab_folder.join("src").is_dir() {
                continue;
            }
            let mut collected = collect(&lab_folder)?;
            collected.left_out.extend(others(&lab_folder, &lab_folder, "src")?);
            handed_in.labs.insert(lab, collected);
        }
    }
    handed_in.left_out.truncate(NAMED);
    Ok(handed_in)
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
        for (lab, collected) in labs {
            let again = all.labs.insert(lab, collected).is_some();
            ensure!(!again, "lab {lab} is in more than one archive in {}", folder.display());
        }
        all.left_out.extend(left_out);
    }
    for other in others {
        all.left_out.push((other.strip_prefix(folder)?.to_owned(), LeftOut::Elsewhere));
    }
    all.left_out.truncate(NAMED);
    Ok(all)
}

/// What lies in a folder beside the one that is looked into.
fn others(folder: &Path, top: &Path, wanted: &str) -> Result<Vec<(PathBuf, LeftOut)>> {
    let mut others = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.file_name().is_none_or(|name| name != wanted) {
            others.push((path.strip_prefix(top)?.to_owned(), LeftOut::Elsewhere));
        }
    }
    others.sort();
    others.truncate(NAMED);
    Ok(others)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use lab_kit::submission::{LeftOut, Sources, pack};

    use super::read;

    fn sources(files: &[(&str, &str)]) -> Sources {
        files.iter().map(|(path, text)| ((*path).into(), text.as_bytes().to_vec())).collect()
    }

    #[test]
    fn uploads_in_a_folder_are_unpacked() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, lab: &str, text: &str| {
            let archive = pack(lab.parse().unwrap(), &sources(&[("src/lib.rs", text)])).unwrap();
            fs::write(folder.path().join(name), archive).unwrap();
        };
        put("one.tar.gz", "1", "first");
        put("two.tgz", "2", "second");
        fs::write(folder.path().join("comment.txt"), "hello").unwrap();
        let handed_in = read(folder.path()).unwrap();
        let texts = handed_in.labs.values().map(|lab| lab.files["src/lib.rs"].as_slice());
        assert_eq!(texts.collect::<Vec<_>>(), [b"first".as_slice(), b"second"]);
        assert_eq!(handed_in.left_out, [("comment.txt".into(), LeftOut::Elsewhere)]);
        put("two again.tgz", "2", "third");
        let error = read(folder.path()).unwrap_err().to_string();
        assert!(error.contains("lab 2 is in more than one archive"), "{error}");
    }
}
