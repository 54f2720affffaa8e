//! Taking in what was handed in: foreign data, read into memory and never unpacked to a disk.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Component, Path};

use anyhow::{Context, Result, bail, ensure};
use flate2::read::GzDecoder;

use super::{COUNT_LIMIT, FILE_LIMIT, Sources, collect, refused};
use crate::kit::Lab;

/// An archive unpacks to at most so many bytes.
const ARCHIVE_LIMIT: u64 = 32 << 20;

/// The sources of each lab in a submission: a `.tar.gz`, or a folder with labs/ in it or one
/// folder below.
///
/// # Errors
/// It is neither, it is damaged, or it is larger than any submission. Files that no lab needs are
/// passed over.
pub(crate) fn read(path: &Path) -> Result<BTreeMap<Lab, Sources>> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if path.is_dir() {
        return folder(path);
    }
    ensure!(
        name.ends_with(".tar.gz") || name.ends_with(".tgz"),
        "{} is neither a folder nor a .tar.gz",
        path.display()
    );
    let file = File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    archive(file).with_context(|| format!("{} cannot be unpacked", path.display()))
}

fn folder(path: &Path) -> Result<BTreeMap<Lab, Sources>> {
    let mut tops = vec![path.to_owned()];
    if !path.join("labs").is_dir() {
        let entries = fs::read_dir(path)?.filter_map(|entry| Some(entry.ok()?.path()));
        tops = entries.filter(|top| top.join("labs").is_dir()).collect();
        ensure!(tops.len() < 2, "{} has labs/ in more than one folder", path.display());
    }
    let mut labs = BTreeMap::new();
    for top in tops {
        for entry in fs::read_dir(top.join("labs"))? {
            let entry = entry?;
            if let Some(lab) = lab_of(&entry.file_name().to_string_lossy()) {
                let files = collect(&entry.path())?.files;
                if !files.is_empty() {
                    labs.insert(lab, files);
                }
            }
        }
    }
    Ok(labs)
}

fn archive(packed: impl Read) -> Result<BTreeMap<Lab, Sources>> {
    let mut archive = tar::Archive::new(GzDecoder::new(packed).take(ARCHIVE_LIMIT));
    let mut labs: BTreeMap<Lab, Sources> = BTreeMap::new();
    for (index, entry) in archive.entries()?.enumerate() {
        ensure!(index < 10 * COUNT_LIMIT, "there are too many files in it");
        let entry = entry?;
        if !entry.header().entry_type().is_file() {
            continue;
        }
        let path = entry.path()?.into_owned();
        let Some((lab, path)) = place(&path) else { continue };
        ensure!(entry.size() <= FILE_LIMIT, "labs/lab{lab}/{path} is larger than 1 MiB");
        let files = labs.entry(lab).or_default();
        ensure!(files.len() < COUNT_LIMIT, "there are more than {COUNT_LIMIT} files in it");
        let mut bytes = Vec::new();
        entry.take(FILE_LIMIT).read_to_end(&mut bytes)?;
        if files.insert(path.clone(), bytes).is_some() {
            bail!("labs/lab{lab}/{path} is in it twice");
        }
    }
    Ok(labs)
}

/// The lab and the path below its folder, of a source file in an archive. Anything with `..`, an
/// absolute path or an odd name has none.
fn place(path: &Path) -> Option<(Lab, String)> {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => parts.push(part.to_str()?),
            Component::CurDir => {}
            _ => return None,
        }
    }
    let labs = parts.iter().take(2).position(|part| *part == "labs")?;
    let lab = lab_of(parts.get(labs + 1)?)?;
    let path = parts[labs + 2..].join("/");
    (path.starts_with("src/") && refused(&path).is_none()).then_some((lab, path))
}

fn lab_of(name: &str) -> Option<Lab> {
    name.strip_prefix("lab")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{archive, place};

    #[test]
    fn only_a_labs_sources_have_a_place() {
        for (path, found) in [
            ("labs/lab2/src/lib.rs", Some("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", Some("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", None),
            ("labs/lab2/build.rs", None),
            ("labs/common/src/lib.rs", None),
            ("labs/lab2/src/../../../x.rs", None),
            ("/labs/lab2/src/lib.rs", None),
            ("labs/lab2/src/.cargo/config.toml", None),
        ] {
            let place = place(Path::new(path)).map(|(_, path)| path);
            assert_eq!(place.as_deref(), found, "{path}");
        }
    }

    #[test]
    fn a_bomb_does_not_go_off() {
        let mut header = tar::Header::new_gnu();
        header.set_size(1 << 40);
        header.set_path("labs/lab1/src/lib.rs").unwrap();
        header.set_cksum();
        let zip = flate2::GzBuilder::new().write(Vec::new(), flate2::Compression::fast());
        let mut zip = zip;
        std::io::Write::write_all(&mut zip, header.as_bytes()).unwrap();
        let packed = zip.finish().unwrap();
        let error = archive(&packed[..]).unwrap_err().to_string();
        assert!(error.contains("larger than 1 MiB"), "{error}");
    }

    #[test]
    fn what_is_damaged_is_an_error() {
        archive(&b"no archive"[..]).unwrap_err();
    }
}
