//! Archives: sound ones, and those that are broken or mean harm.

use std::fs;
use std::io::{Cursor, Write};
use std::os::unix::fs::symlink;
use std::path::Path;

use flate2::Compression;
use flate2::write::GzEncoder;
use zip::write::{SimpleFileOptions, ZipWriter};

use crate::expected::{EMPTY, Expected, NOT_BUILT, Times, UNREADABLE};
use crate::sources::{Files, kit, solution};

type Tar = tar::Builder<GzEncoder<Vec<u8>>>;

/// Odd archives: their file, what is in it, what must come of it.
pub(crate) fn all(lab: u8) -> Vec<(&'static str, Vec<u8>, Expected)> {
    let unreadable = |why: &str| Expected::ends(UNREADABLE, why);
    let mut cut = tar(lab, &solution(lab));
    cut.truncate(cut.len() / 2);
    let without = |left_out| Expected::Graded { lost: Vec::new(), left_out, times: Times::Any };
    let conflict = |folder: &str| {
        let more = [folder.to_owned(), format!("{folder}/b.rs")].map(|path| (path, String::new()));
        tar(lab, &solution(lab).into_iter().chain(more).collect())
    };
    vec![
        ("odd-zip.zip", odd(lab), without(&["no plain file", "leads out of the submission"])),
        ("long-names.tar.gz", long_names(lab), without(&["longer than 200 bytes"])),
        ("nul.zip", renamed(lab, b"a\0"), without(&["a control character"])),
        ("twice.zip", renamed(lab, b"bb"), unreadable("two files in it have the same name")),
        ("file-and-folder.tar.gz", conflict("src/a"), unreadable("src/a in it is a file and a")),
        ("below-a-file.tar.gz", conflict("src/lib.rs"), unreadable("a file and a folder")),
        ("links.tar.gz", links(lab), Expected::ends(NOT_BUILT, "src/lib.rs")),
        ("broken.tar.gz", b"no archive".to_vec(), unreadable("cannot be unpacked")),
        ("broken-zip.zip", b"PK no archive".to_vec(), unreadable("cannot be unpacked")),
        ("cut-off.tar.gz", cut, unreadable("cannot be unpacked")),
        ("nothing.zip", Vec::new(), unreadable("cannot be unpacked")),
        ("what.rar", b"who knows".to_vec(), unreadable("neither a folder nor")),
        ("bomb.tar.gz", bomb_tar(lab), unreadable("larger than 1 MiB")),
        ("bomb-zip.zip", bomb_zip(lab), unreadable("larger than 1 MiB")),
    ]
}

/// What the command calls such a file.
pub(crate) fn stem(name: &str) -> &str {
    let stem = |ending: &&str| name.strip_suffix(*ending);
    [".tar.gz", ".zip"].iter().find_map(stem).unwrap_or(name)
}

/// Makes a link to all of the kit's solutions.
pub(crate) fn link_to_solutions(place: &Path) -> Expected {
    symlink(kit().join("solutions"), place).unwrap();
    Expected::ends(UNREADABLE, "is a link")
}

/// Makes a folder whose sources are a link to the solution.
pub(crate) fn linked(lab: u8, folder: &Path) -> Expected {
    fs::create_dir_all(folder).unwrap();
    symlink(kit().join(format!("solutions/lab{lab}/src")), folder.join("src")).unwrap();
    Expected::ends(EMPTY, format!("no labs/lab{lab}/src"))
}

/// A `.zip` of sources.
pub(crate) fn zip(lab: u8, files: &Files) -> Vec<u8> {
    filled(lab, files).finish().unwrap().into_inner()
}

/// A `.tar.gz` of sources.
pub(crate) fn tar(lab: u8, files: &Files) -> Vec<u8> {
    let mut tar = Tar::new(GzEncoder::new(Vec::new(), Compression::fast()));
    for (path, text) in files {
        append(&mut tar, &format!("labs/lab{lab}/{path}"), text.as_bytes());
    }
    tar.into_inner().unwrap().finish().unwrap()
}

fn append(tar: &mut Tar, path: &str, bytes: &[u8]) {
    let mut header = tar::Header::new_gnu();
    header.set_size(bytes.len() as u64);
    header.set_mode(0o644);
    tar.append_data(&mut header, path, bytes).unwrap();
}

fn plain() -> SimpleFileOptions {
    SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated)
}

fn filled(lab: u8, files: &Files) -> ZipWriter<Cursor<Vec<u8>>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, text) in files {
        zip.start_file(format!("labs/lab{lab}/{path}"), plain()).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip
}

/// The solution, and paths that lead elsewhere.
fn odd(lab: u8) -> Vec<u8> {
    let mut zip = filled(lab, &solution(lab));
    zip.start_file(format!("labs/lab{lab}/src/../../../../escaped.rs"), plain()).unwrap();
    zip.add_symlink(format!("labs/lab{lab}/src/link.rs"), "/etc/passwd", plain()).unwrap();
    zip.finish().unwrap().into_inner()
}

/// The solution, and names that no disk takes or no page shows.
fn long_names(lab: u8) -> Vec<u8> {
    let mut files = solution(lab);
    for name in ["a".repeat(300), "a/".repeat(2100), "a".repeat(8 << 20)] {
        files.insert(format!("src/{name}.rs"), String::new());
    }
    tar(lab, &files)
}

/// The solution and two empty files, `aa.rs` and `bb.rs`, with `name` in the place of `aa`.
fn renamed(lab: u8, name: &[u8; 2]) -> Vec<u8> {
    let mut files = solution(lab);
    files.extend(["aa", "bb"].map(|name| (format!("src/{name}.rs"), String::new())));
    let mut bytes = zip(lab, &files);
    for at in 0..bytes.len() - 9 {
        if &bytes[at..at + 9] == b"src/aa.rs" {
            bytes[at + 4..at + 6].copy_from_slice(name);
        }
    }
    bytes
}

/// A link to the solution in the place of a source.
fn links(lab: u8) -> Vec<u8> {
    let mut tar = Tar::new(GzEncoder::new(Vec::new(), Compression::fast()));
    let mut header = tar::Header::new_gnu();
    header.set_entry_type(tar::EntryType::Symlink);
    header.set_size(0);
    let own = kit().join(format!("solutions/lab{lab}/src/lib.rs"));
    tar.append_link(&mut header, format!("labs/lab{lab}/src/lib.rs"), own).unwrap();
    append(&mut tar, &format!("labs/lab{lab}/src/other.rs"), b" ");
    tar.into_inner().unwrap().finish().unwrap()
}

/// What a bomb holds: 64 MiB of nothing.
fn zeros() -> Vec<u8> {
    vec![0; 64 << 20]
}

fn bomb_tar(lab: u8) -> Vec<u8> {
    let mut tar = Tar::new(GzEncoder::new(Vec::new(), Compression::fast()));
    append(&mut tar, &format!("labs/lab{lab}/src/lib.rs"), &zeros());
    tar.into_inner().unwrap().finish().unwrap()
}

fn bomb_zip(lab: u8) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file(format!("labs/lab{lab}/src/lib.rs"), plain()).unwrap();
    zip.write_all(&zeros()).unwrap();
    zip.finish().unwrap().into_inner()
}
