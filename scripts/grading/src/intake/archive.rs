//! Archives: of either kind, only plain files below labs/labN/src are unpacked, into memory.

use std::io::{Cursor, Read};
use std::path::PathBuf;

use anyhow::{Result, ensure};
use flate2::read::GzDecoder;

use super::HandedIn;
use lab_kit::submission::NOT_UTF8;

/// Bytes of an archive that are looked through: what is skipped costs little, but it costs.
const UNPACKED: u64 = 256 << 20;
const TOO_LARGE: &str =
    "it is larger than 256 MiB: a submission is a lab's src, without the folder target";

/// The most entries of an archive.
pub(super) const ENTRIES: usize = 100_000;

/// Takes in a `.tar.gz`.
pub(crate) fn tar_gz(packed: impl Read) -> Result<HandedIn> {
    tar(GzDecoder::new(packed))
}

/// Takes in a `.tar`.
pub(crate) fn tar(unpacked: impl Read) -> Result<HandedIn> {
    let mut archive = tar::Archive::new(unpacked.take(UNPACKED));
    let (mut handed_in, mut passed) = (HandedIn::default(), 0);
    for (index, entry) in archive.entries()?.enumerate() {
        ensure!(index < ENTRIES, "there are more than {ENTRIES} files in it");
        let entry = entry?;
        let kind = entry.header().entry_type();
        // What only says something about the archive, or is a folder, is nobody's work.
        if kind.is_dir() || kind.is_pax_global_extensions() || kind.is_pax_local_extensions() {
            continue;
        }
        let path = entry.path()?.into_owned();
        let size = entry.size();
        handed_in.add(&path, kind.is_file(), size, || Ok(entry))?;
        passed = size.saturating_add(passed);
        ensure!(passed <= UNPACKED, TOO_LARGE);
    }
    Ok(handed_in)
}

/// Takes in a `.zip`.
pub(crate) fn zip(packed: impl Read) -> Result<HandedIn> {
    let mut bytes = Vec::new();
    packed.take(UNPACKED + 1).read_to_end(&mut bytes)?;
    ensure!(bytes.len() as u64 <= UNPACKED, TOO_LARGE);
    let mut archive = zip::ZipArchive::new(Cursor::new(&bytes))?;
    ensure!(archive.len() <= ENTRIES, "there are more than {ENTRIES} files in it");
    // Of entries with one name the last would be taken.
    let alone = entries(&bytes).is_none_or(|said| said == archive.len());
    ensure!(alone, "two files in it have the same name");
    let mut handed_in = HandedIn::default();
    let mut unpacked = 0;
    for index in 0..archive.len() {
        let entry = archive.by_index(index)?;
        if entry.is_dir() {
            continue;
        }
        let plain = entry.is_file() && !entry.is_symlink();
        let size = entry.size();
        let Ok(name) = std::str::from_utf8(entry.name_raw()).map(PathBuf::from) else {
            let shown = String::from_utf8_lossy(entry.name_raw()).into_owned();
            handed_in.leave_out(shown.as_ref(), NOT_UTF8);
            continue;
        };
        unpacked += handed_in.add(&name, plain, size, || Ok(entry))?;
        ensure!(unpacked <= UNPACKED, TOO_LARGE);
    }
    Ok(handed_in)
}

/// How many entries a zip's last record speaks of; none if it is of a form that has more.
fn entries(zip: &[u8]) -> Option<usize> {
    let end = zip.windows(4).rposition(|window| window == b"PK\x05\x06")?;
    let count = u16::from_le_bytes(zip.get(end + 10..end + 12)?.try_into().ok()?);
    (count < u16::MAX).then_some(usize::from(count))
}
