//! Unpacks archives of all kinds into memory. Only plain files below labs/labN/src are unpacked.

use std::ffi::OsStr;
use std::io::{self, Cursor, Read};
use std::os::unix::ffi::OsStrExt;
use std::path::PathBuf;

use anyhow::{Result, ensure};
use bzip2::read::MultiBzDecoder;
use flate2::read::GzDecoder;
use lzma_rust2::XzReader;

use super::handed_in::HandedIn;

/// Maximal number of bytes read from an archive. Skipped entries count too, because they also take
/// time.
const UNPACKED: u64 = 256 << 20;
const TOO_LARGE: &str =
    "it is larger than 256 MiB: a submission is a lab's src, without the folder target";

/// Maximal number of entries in an archive.
pub(super) const ENTRIES: usize = 100_000;

/// Number of bytes at the beginning of a file that determine its type.
const HEAD: u64 = 512;

/// Maximal number of nested layers of compression. A browser may add a layer.
const TIMES: usize = 3;

/// First bytes of files that are compressed by gzip, bzip2 and xz, and of a zip.
const GZIP: &[u8] = &[0x1f, 0x8b];
const BZIP2: &[u8] = b"BZh";
const XZ: &[u8] = b"\xfd7zXZ\0";
const ZIP: &[u8] = b"PK";

/// Whether a file that begins with `head` is an archive. Its name does not matter, because browsers
/// and platforms rename files.
pub(super) fn is_archive(head: &[u8]) -> bool {
    [GZIP, BZIP2, XZ, ZIP].iter().any(|begin| head.starts_with(begin)) || is_tar(head)
}

/// Whether a file is a tar. An old tar has no magic number, but a checksum of its first block.
fn is_tar(head: &[u8]) -> bool {
    let Some(block) = head.first_chunk::<512>() else { return false };
    let mut header = tar::Header::new_old();
    header.as_mut_bytes().copy_from_slice(block);
    let checksum = header.cksum();
    header.set_cksum();
    block[0] != 0 && checksum.is_ok_and(|checksum| header.cksum().is_ok_and(|sum| sum == checksum))
}

/// Reads the first bytes of a file.
pub(super) fn head(file: impl Read) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    file.take(HEAD).read_to_end(&mut head)?;
    Ok(head)
}

/// Unpacks an archive: a zip or a tar, or either of them compressed by gzip, bzip2 or xz.
///
/// If the archive contains no lab but a single other archive, that inner archive is unpacked.
pub(crate) fn unpack(packed: impl Read) -> Result<HandedIn> {
    let outer = unpack_layers(packed)?;
    match &outer.archives[..] {
        [inner] if outer.labs.is_empty() => unpack_layers(&inner[..]),
        _ => Ok(outer),
    }
}

fn unpack_layers(packed: impl Read) -> Result<HandedIn> {
    let mut packed: Box<dyn Read + '_> = Box::new(packed);
    for _ in 0..TIMES {
        let head = head(&mut packed)?;
        let begins = head.clone();
        let rewound = Cursor::new(head).chain(packed);
        if begins.starts_with(ZIP) {
            return zip(rewound);
        }
        packed = if begins.starts_with(GZIP) {
            Box::new(GzDecoder::new(rewound))
        } else if begins.starts_with(BZIP2) {
            Box::new(MultiBzDecoder::new(rewound))
        } else if begins.starts_with(XZ) {
            Box::new(XzReader::new(rewound, true))
        } else {
            return tar(rewound);
        };
    }
    tar(packed)
}

fn tar(unpacked: impl Read) -> Result<HandedIn> {
    let mut archive = tar::Archive::new(unpacked.take(UNPACKED));
    let mut handed_in = HandedIn::default();
    let mut passed = 0;
    for (index, entry) in archive.entries()?.enumerate() {
        ensure!(index < ENTRIES, "there are more than {ENTRIES} files in it");
        let entry = entry?;
        let kind = entry.header().entry_type();
        // Folders and entries about the archive itself are not a student's work.
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

fn zip(packed: impl Read) -> Result<HandedIn> {
    let mut bytes = Vec::new();
    packed.take(UNPACKED + 1).read_to_end(&mut bytes)?;
    ensure!(bytes.len() as u64 <= UNPACKED, TOO_LARGE);
    let mut archive = zip::ZipArchive::new(Cursor::new(&bytes))?;
    ensure!(archive.len() <= ENTRIES, "there are more than {ENTRIES} files in it");
    // Of two entries with the same name, only the last would be read.
    let alone = entries(&bytes).is_none_or(|count| count == archive.len());
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
        let name = PathBuf::from(OsStr::from_bytes(entry.name_raw()));
        unpacked += handed_in.add(&name, plain, size, || Ok(entry))?;
        ensure!(unpacked <= UNPACKED, TOO_LARGE);
    }
    Ok(handed_in)
}

/// Returns the number of entries in a zip; `None` if its last record cannot hold the number.
fn entries(zip: &[u8]) -> Option<usize> {
    let end = zip.windows(4).rposition(|window| window == b"PK\x05\x06")?;
    let count = u16::from_le_bytes(zip.get(end + 10..end + 12)?.try_into().ok()?);
    (count < u16::MAX).then_some(usize::from(count))
}
