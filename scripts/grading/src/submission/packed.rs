//! Tests archives of forty kinds. A mark must not depend on the name of an archive.

use std::ffi::OsStr;
use std::fs;
use std::io::{Cursor, Write};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

use bzip2::write::BzEncoder;
use flate2::Compression;
use flate2::write::GzEncoder;
use lzma_rust2::{XzOptions, XzWriter};
use zip::write::{SimpleFileOptions, ZipWriter};

use super::names::name;
use super::take;
use lab_kit::files::write_file;
use lab_kit::{Given, Kit};

const WORK: &[u8] = b"pub fn f() {}\n";

/// Paths in an archive at which the one file with a task may be.
const PLACES: [&[u8]; 16] = [
    b"labs/lab1/src/force.rs",
    b"./labs/lab1/src/force.rs",
    b"kit/labs/lab1/src/force.rs",
    b"home/ada/course/kit-main/labs/lab1/src/force.rs",
    b"labs/labs/lab1/src/force.rs",
    b"kit\\labs\\lab1\\src\\force.rs",
    b"Jos\xe9/labs/lab1/src/force.rs",
    b"\xff\xfe\\labs\\lab1\\src\\force.rs",
    b"Jose\xcc\x81/labs/lab1/src/force.rs",
    b"lab1/src/force.rs",
    b"my work/final version/src/force.rs",
    b"src/force.rs",
    b"force.rs",
    b"lab1/force.rs",
    b"handed in/force.rs",
    b"labs/lab1/force.rs",
];

/// Names of archives, from platforms, browsers and students, and the names of the submissions.
const NAMES: [(&str, &str); 16] = [
    ("ada.tar.gz", "ada"),
    ("ada.tgz", "ada"),
    ("ada.TAR.GZ", "ada"),
    ("ada.gz", "ada"),
    ("ada.tar-1.gz", "ada"),
    ("ada.tar (1).gz", "ada"),
    ("ada (2).tar.gz", "ada"),
    ("ada.tar", "ada"),
    ("ada.tar.bz2", "ada"),
    ("ada.tar (1).xz", "ada"),
    ("ada.ZIP", "ada"),
    ("ada (1).zip", "ada"),
    ("ada.tar.gz.gz", "ada"),
    ("group-1.zip", "group-1"),
    ("ada.bin", "ada.bin"),
    ("ada", "ada"),
];

fn tar(place: &[u8]) -> Vec<u8> {
    let mut tar = tar::Builder::new(Vec::new());
    let mut header = tar::Header::new_gnu();
    header.set_size(WORK.len() as u64);
    // The library refuses a path that is not UTF-8, so its bytes are written directly.
    header.as_old_mut().name[..place.len()].copy_from_slice(place);
    header.set_cksum();
    tar.append(&header, WORK).unwrap();
    tar.into_inner().unwrap()
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
    packed.write_all(bytes).unwrap();
    packed.finish().unwrap()
}

fn bzip2(bytes: &[u8]) -> Vec<u8> {
    let mut packed = BzEncoder::new(Vec::new(), bzip2::Compression::fast());
    packed.write_all(bytes).unwrap();
    packed.finish().unwrap()
}

fn xz(bytes: &[u8]) -> Vec<u8> {
    let mut packed = XzWriter::new(Vec::new(), XzOptions::with_preset(0)).unwrap();
    packed.write_all(bytes).unwrap();
    packed.finish().unwrap()
}

fn zip(place: &str, bytes: &[u8]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file(place, SimpleFileOptions::DEFAULT).unwrap();
    zip.write_all(bytes).unwrap();
    zip.finish().unwrap().into_inner()
}

/// Returns the source that is taken from a submission of lab 1.
fn taken(path: &Path) -> Vec<u8> {
    let tasks = ["src/force.rs".to_owned()].into();
    let given = Given { tasks, ..Given::default() };
    let submission = take(&Kit::find().unwrap(), "1".parse().unwrap(), &given, path);
    let mut submission = submission.unwrap_or_else(|why| panic!("{}: {why:#}", path.display()));
    submission.files.remove("src/force.rs").unwrap_or_else(|| panic!("{}", path.display()))
}

#[test]
fn an_archive_is_known_by_its_content() {
    let class = tempfile::tempdir().unwrap();
    let plain = tar(PLACES[0]);
    let forms = [
        plain.clone(),
        gzip(&plain),
        gzip(&gzip(&plain)),
        bzip2(&plain),
        xz(&plain),
        zip("kit/labs/lab1/src/force.rs", WORK),
        zip("handed in/lab1.tar.gz", &gzip(&plain)),
    ];
    for (file, called) in NAMES {
        let path = class.path().join(file);
        assert_eq!(name(&path), called);
        for form in &forms {
            fs::write(&path, form).unwrap();
            assert_eq!(taken(&path), WORK, "{file}");
        }
    }
}

#[test]
fn work_is_found_wherever_it_lies() {
    let class = tempfile::tempdir().unwrap();
    for (number, place) in PLACES.iter().enumerate() {
        let shown = String::from_utf8_lossy(place);
        let path = class.path().join(format!("{number}.tar.gz"));
        fs::write(&path, gzip(&tar(place))).unwrap();
        assert_eq!(taken(&path), WORK, "{shown}");
        if let Ok(place) = std::str::from_utf8(place) {
            let path = class.path().join(format!("{number}.zip"));
            fs::write(&path, zip(place, WORK)).unwrap();
            assert_eq!(taken(&path), WORK, "{shown}");
        }
        if place.contains(&b'\\') {
            continue;
        }
        let folder = class.path().join(number.to_string());
        write_file(&folder.join(OsStr::from_bytes(place)), WORK).unwrap();
        assert_eq!(taken(&folder), WORK, "a folder with {shown}");
    }
}

#[test]
fn what_platforms_export_is_unpacked() {
    let class = tempfile::tempdir().unwrap();
    let archive = gzip(&tar(b"labs/lab1/src/force.rs"));
    for place in
        ["lab1.tar-1.gz", "Ada Lovelace_4711/submission/lab1.gz", "lab1", "a/b/c/d/lab1.zip"]
    {
        let folder = tempfile::tempdir_in(class.path()).unwrap();
        for (file, bytes) in
            [(place, &archive[..]), ("comment.txt", b"please"), ("__MACOSX/._lab1", b"macOS")]
        {
            write_file(&folder.path().join(file), bytes).unwrap();
        }
        assert_eq!(taken(folder.path()), WORK, "{place}");
    }
}

#[test]
fn a_whole_kit_has_the_lab_once() {
    let class = tempfile::tempdir().unwrap();
    for copy in [
        "target/lab/graded/lab1/labs/lab1/src",
        "solutions/lab1/src",
        "kept/lab1-1/src",
        ".git/labs/lab1/src",
    ] {
        let folder = class.path().join(copy.replace('/', "-"));
        for place in ["kit/labs/lab1/src", &format!("kit/{copy}")] {
            let text = if place.starts_with("kit/labs") { WORK } else { b"another" };
            write_file(&folder.join(place).join("force.rs"), text).unwrap();
        }
        assert_eq!(taken(&folder), WORK, "{copy}");
        let mut all = tar::Builder::new(Vec::new());
        all.append_dir_all(".", &folder).unwrap();
        let path = folder.with_extension("tar");
        fs::write(&path, all.into_inner().unwrap()).unwrap();
        assert_eq!(taken(&path), WORK, "{copy}");
    }
}

#[test]
fn a_name_that_means_two_files_is_not_guessed() {
    let class = tempfile::tempdir().unwrap();
    let tasks = ["src/force.rs".to_owned(), "src/a/mod.rs".to_owned(), "src/b/mod.rs".to_owned()];
    let given = Given { tasks: tasks.into(), ..Given::default() };
    let cases: [(&[&str], &[&str]); 6] = [
        (&["old/force.rs", "new/force.rs"], &[]),
        (&["old/src/force.rs", "new/src/force.rs"], &[]),
        // The second file is new.
        (&["force.rs", "mod.rs"], &["src/force.rs", "src/mod.rs"]),
        (&["a/mod.rs", "b/mod.rs"], &["src/a/mod.rs", "src/b/mod.rs"]),
        (&["force.rs", "own.rs", "notes.pdf"], &["src/force.rs", "src/own.rs"]),
        // The file is in the folder of a different lab.
        (&["lab2/src/force.rs"], &[]),
    ];
    for (names, taken) in cases {
        let folder = tempfile::tempdir_in(class.path()).unwrap();
        for name in names {
            write_file(&folder.path().join(name), WORK).unwrap();
        }
        let submission = take(&Kit::find().unwrap(), "1".parse().unwrap(), &given, folder.path());
        let files: Vec<String> = submission.unwrap().files.into_keys().collect();
        assert_eq!(files, taken, "{names:?}");
    }
}
