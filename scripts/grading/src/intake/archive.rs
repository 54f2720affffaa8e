//! Archives: of either kind, only plain files below labs/labN/src are unpacked, into memory.

use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use anyhow::{Result, bail, ensure};
use flate2::read::GzDecoder;

use super::place::{Place, place};
use super::{HandedIn, NAMED};
use lab_kit::submission::{COUNT_LIMIT, FILE_LIMIT, LeftOut};

/// An archive unpacks to at most so many bytes.
const ARCHIVE_LIMIT: u64 = 32 << 20;

/// It has at most so many entries.
const ENTRIES: usize = 10 * COUNT_LIMIT;

/// Takes in a `.tar.gz`.
pub(crate) fn tar(packed: impl Read) -> Result<HandedIn> {
    let mut archive = tar::Archive::new(GzDecoder::new(packed).take(ARCHIVE_LIMIT));
    let mut handed_in = HandedIn::default();
    for (index, entry) in archive.entries()?.enumerate() {
        ensure!(index < ENTRIES, "there are too many files in it");
        let entry = entry?;
        let kind = entry.header().entry_type();
        // What only says something about the archive, or is a folder, is nobody's work.
        if kind.is_dir() || kind.is_pax_global_extensions() || kind.is_pax_local_extensions() {
            continue;
        }
        let path = entry.path()?.into_owned();
        let size = entry.size();
        add(&mut handed_in, &path, kind.is_file(), size, entry)?;
    }
    Ok(handed_in)
}

/// Takes in a `.zip`.
pub(crate) fn zip(packed: impl Read) -> Result<HandedIn> {
    let mut bytes = Vec::new();
    packed.take(ARCHIVE_LIMIT + 1).read_to_end(&mut bytes)?;
    ensure!(bytes.len() as u64 <= ARCHIVE_LIMIT, "it is larger than any submission");
    let mut archive = zip::ZipArchive::new(Cursor::new(&bytes))?;
    ensure!(archive.len() <= ENTRIES, "there are too many files in it");
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
            leave_out(&mut handed_in, shown.as_ref(), LeftOut::Name);
            continue;
        };
        unpacked += add(&mut handed_in, &name, plain, size, entry)?;
        ensure!(unpacked <= ARCHIVE_LIMIT, "it unpacks to more than any submission");
    }
    Ok(handed_in)
}

/// How many entries a zip's last record speaks of; none if it is of a form that has more.
fn entries(zip: &[u8]) -> Option<usize> {
    let end = zip.windows(4).rposition(|window| window == b"PK\x05\x06")?;
    let count = u16::from_le_bytes(zip.get(end + 10..end + 12)?.try_into().ok()?);
    (count < u16::MAX).then_some(usize::from(count))
}

/// Takes an entry if it has a place, and returns the number of bytes that it had.
fn add(
    handed_in: &mut HandedIn,
    path: &Path,
    plain: bool,
    size: u64,
    entry: impl Read,
) -> Result<u64> {
    let (lab, path) = match place(path) {
        // `cargo lab submit` puts it there.
        Place::Out(LeftOut::Elsewhere) if path.ends_with("submission.json") => return Ok(0),
        Place::Out(why) => {
            leave_out(handed_in, path, why);
            return Ok(0);
        }
        Place::Source(..) if !plain => {
            leave_out(handed_in, path, LeftOut::NotPlain);
            return Ok(0);
        }
        Place::Source(lab, path) => (lab, path),
    };
    ensure!(size <= FILE_LIMIT, "labs/lab{lab}/{path} is larger than 1 MiB");
    let files = &mut handed_in.labs.entry(lab).or_default().files;
    ensure!(files.len() < COUNT_LIMIT, "there are more than {COUNT_LIMIT} files in it");
    let mut bytes = Vec::new();
    // Its size is what it says of itself.
    entry.take(FILE_LIMIT + 1).read_to_end(&mut bytes)?;
    let read = bytes.len() as u64;
    ensure!(read <= FILE_LIMIT, "labs/lab{lab}/{path} is larger than 1 MiB");
    if files.insert(path.clone(), bytes).is_some() {
        bail!("labs/lab{lab}/{path} is in it twice");
    }
    Ok(read)
}

fn leave_out(handed_in: &mut HandedIn, path: &Path, why: LeftOut) {
    if handed_in.left_out.len() < NAMED {
        handed_in.left_out.push((path.to_owned(), why));
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Cursor, Write};

    use zip::write::{SimpleFileOptions, ZipWriter};

    use super::{tar, zip};
    use lab_kit::submission::LeftOut;

    const SOURCE: &str = "labs/lab1/src/lib.rs";

    type Zip = ZipWriter<Cursor<Vec<u8>>>;

    fn zipped(write: impl FnOnce(&mut Zip, SimpleFileOptions)) -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let plain = SimpleFileOptions::default();
        write(&mut writer, plain.compression_method(zip::CompressionMethod::Deflated));
        writer.finish().unwrap().into_inner()
    }

    /// An archive of two empty sources, `aa.rs` and `bb.rs`, with `name` in the place of `aa`.
    fn renamed(name: &[u8; 2]) -> Vec<u8> {
        let mut bytes = zipped(|zip, how| {
            for name in ["aa", "bb"] {
                zip.start_file(format!("labs/lab1/src/{name}.rs"), how).unwrap();
            }
        });
        for at in 0..bytes.len() - 5 {
            if &bytes[at..at + 5] == b"aa.rs" {
                bytes[at..at + 2].copy_from_slice(name);
            }
        }
        bytes
    }

    fn left_out(handed_in: &super::HandedIn) -> Vec<(String, LeftOut)> {
        let shown = |path: &std::path::Path| path.to_string_lossy().into_owned();
        handed_in.left_out.iter().map(|(path, why)| (shown(path), *why)).collect()
    }

    #[test]
    fn a_zip_gives_what_a_tar_gives() {
        let file = zipped(|zip, how| {
            for path in ["labs/lab1/src/lib.rs", "labs/lab1/build.rs", "labs/lab1/src/../../x.rs"] {
                zip.start_file(path, how).unwrap();
                zip.write_all(b"fn f() {}").unwrap();
            }
            zip.add_symlink("labs/lab1/src/link.rs", "/etc/passwd", how).unwrap();
        });
        let handed_in = zip(&file[..]).unwrap();
        let files = &handed_in.labs[&"1".parse().unwrap()].files;
        assert_eq!(files.keys().collect::<Vec<_>>(), ["src/lib.rs"]);
        let names = ["labs/lab1/build.rs", "labs/lab1/src/../../x.rs", "labs/lab1/src/link.rs"];
        let reasons = [LeftOut::Elsewhere, LeftOut::Outside, LeftOut::NotPlain];
        let expected: Vec<_> = names.map(String::from).into_iter().zip(reasons).collect();
        assert_eq!(left_out(&handed_in), expected);
    }

    #[test]
    fn odd_names_have_no_place() {
        for (name, why) in [(b"\xff\xfe", LeftOut::Name), (b"a\0", LeftOut::Unfit)] {
            let handed_in = zip(&renamed(name)[..]).unwrap();
            assert_eq!(handed_in.labs[&"1".parse().unwrap()].files.len(), 1);
            assert_eq!(left_out(&handed_in)[0].1, why);
        }
        let archive = zipped(|zip, how| {
            for long in ["a".repeat(300), "a/".repeat(2100)] {
                zip.start_file(format!("labs/lab1/src/{long}.rs"), how).unwrap();
            }
        });
        let handed_in = zip(&archive[..]).unwrap();
        assert!(handed_in.labs.is_empty());
        assert!(left_out(&handed_in).iter().all(|(_, why)| *why == LeftOut::Unfit));
    }

    #[test]
    fn of_two_entries_with_one_name_none_is_taken() {
        let error = zip(&renamed(b"bb")[..]).unwrap_err().to_string();
        assert_eq!(error, "two files in it have the same name");
    }

    #[test]
    fn a_zip_bomb_does_not_go_off() {
        let file = zipped(|zip, how| {
            zip.start_file(SOURCE, how).unwrap();
            let zeros = vec![0; 1 << 20];
            (0..64).for_each(|_| zip.write_all(&zeros).unwrap());
        });
        let error = zip(&file[..]).unwrap_err().to_string();
        assert!(error.contains("larger than 1 MiB"), "{error}");
        let many = zipped(|zip, how| {
            for number in 0..super::ENTRIES + 1 {
                zip.start_file(format!("labs/lab1/src/{number}.rs"), how).unwrap();
            }
        });
        assert!(zip(&many[..]).unwrap_err().to_string().contains("too many"));
    }

    #[test]
    fn a_tar_bomb_does_not_go_off() {
        let mut header = tar::Header::new_gnu();
        header.set_size(1 << 40);
        header.set_path(SOURCE).unwrap();
        header.set_cksum();
        let mut zip = flate2::GzBuilder::new().write(Vec::new(), flate2::Compression::fast());
        zip.write_all(header.as_bytes()).unwrap();
        let packed = zip.finish().unwrap();
        let error = tar(&packed[..]).unwrap_err().to_string();
        assert!(error.contains("larger than 1 MiB"), "{error}");
    }

    #[test]
    fn what_is_damaged_is_an_error() {
        tar(&b"no archive"[..]).unwrap_err();
        zip(&b"PK no archive"[..]).unwrap_err();
    }
}
