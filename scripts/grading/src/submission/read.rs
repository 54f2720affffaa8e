//! Taking in what was handed in: foreign data, read into memory and never unpacked to a disk.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::{Component, Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use lab_kit::Lab;
use lab_kit::submission::{Collected, LeftOut, collect, refused};

use super::archive;

/// Of the files that are not taken, so many are named.
pub(super) const NAMED: usize = 100;

/// What was handed in.
#[derive(Debug, Default)]
pub(crate) struct HandedIn {
    /// By lab; a lab without any source is not there.
    pub(crate) labs: BTreeMap<Lab, Collected>,
    /// What belongs to no lab.
    pub(crate) left_out: Vec<(PathBuf, LeftOut)>,
}

/// Where a file of a submission belongs.
#[derive(Debug, PartialEq)]
pub(super) enum Place {
    /// To a lab, by its path below the lab's folder.
    Source(Lab, String),
    /// Nowhere.
    Out(LeftOut),
}

/// The sources of each lab in a submission: a `.tar.gz` or a `.zip`, or a folder, with labs/ in it
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
    ensure!(metadata.is_file(), "{} is no plain file and no folder", path.display());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let open = || File::open(path).with_context(|| format!("cannot read {}", path.display()));
    let handed_in = match packed_as(path) {
        Some(Packed::Tar) => archive::tar(open()?),
        Some(Packed::Zip) => archive::zip(open()?),
        None => bail!("{name} is neither a folder nor a .tar.gz or .zip"),
    };
    handed_in.with_context(|| format!("{name} cannot be unpacked"))
}

enum Packed {
    Tar,
    Zip,
}

/// What kind of archive it is by its name, if it is one.
fn packed_as(path: &Path) -> Option<Packed> {
    let name = path.file_name()?.to_string_lossy();
    let ends = |endings: &[&str]| endings.iter().any(|ending| name.ends_with(ending));
    if ends(&[".tar.gz", ".tgz"]) {
        return Some(Packed::Tar);
    }
    ends(&[".zip"]).then_some(Packed::Zip)
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
        entries.partition(|path| plain(path) && packed_as(path).is_some());
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

/// Where a path in an archive belongs. Anything with `..`, an absolute path or an odd name has no
/// place.
pub(super) fn place(path: &Path) -> Place {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => match part.to_str() {
                // What one system calls a name is a path to another.
                Some(part) if part.contains('\\') => return Place::Out(LeftOut::Outside),
                Some(part) => parts.push(part),
                None => return Place::Out(LeftOut::Name),
            },
            Component::CurDir => {}
            _ => return Place::Out(LeftOut::Outside),
        }
    }
    let source = || {
        let labs = parts.iter().take(2).position(|part| *part == "labs")?;
        let lab = lab_of(parts.get(labs + 1)?)?;
        let path = parts[labs + 2..].join("/");
        path.starts_with("src/").then_some((lab, path))
    };
    match source() {
        None => Place::Out(LeftOut::Elsewhere),
        Some((lab, path)) => refused(&path).map_or(Place::Source(lab, path), Place::Out),
    }
}

fn lab_of(name: &str) -> Option<Lab> {
    name.strip_prefix("lab")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{LeftOut, Place, place};

    #[test]
    fn only_a_labs_sources_have_a_place() {
        let source = |path: &str| Place::Source("2".parse().unwrap(), path.into());
        for (path, found) in [
            ("labs/lab2/src/lib.rs", source("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", source("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", Place::Out(LeftOut::Elsewhere)),
            ("labs/lab2/build.rs", Place::Out(LeftOut::Elsewhere)),
            (".cargo/config.toml", Place::Out(LeftOut::Elsewhere)),
            ("labs/common/src/lib.rs", Place::Out(LeftOut::Elsewhere)),
            ("labs/lab2/src/../../../x.rs", Place::Out(LeftOut::Outside)),
            ("labs/lab2/src\\..\\x.rs", Place::Out(LeftOut::Outside)),
            ("/labs/lab2/src/lib.rs", Place::Out(LeftOut::Outside)),
            ("labs/lab2/src/.cargo/config.toml", Place::Out(LeftOut::Hidden)),
        ] {
            assert_eq!(place(Path::new(path)), found, "{path}");
        }
    }
}
