//! Archives that students hand in. `src/submission/archive_tests.rs` tests damaged and unusual archives.

use std::io::{Cursor, Write};

use lab_kit::sources::pack;
use zip::write::{SimpleFileOptions, ZipWriter};

use crate::expected::{EMPTY, Expected, UNREADABLE};
use crate::solution::Files;

/// Returns unusual archives: their names, their bytes, and the expected results.
pub(crate) fn all(lab: u8) -> Vec<(&'static str, Vec<u8>, Expected)> {
    let without_tasks = [("src/other.rs".to_owned(), String::new())].into();
    let unreadable = Expected::ends(UNREADABLE, "cannot be unpacked");
    vec![
        ("without-tasks.tar.gz", tar(lab, &without_tasks), Expected::ends(EMPTY, "no task's file")),
        ("broken.tar.gz", b"no archive".to_vec(), unreadable),
    ]
}

/// Makes a `.tar.gz` of sources.
pub(crate) fn tar(lab: u8, files: &Files) -> Vec<u8> {
    let files = files.iter().map(|(path, text)| (path.clone(), text.clone().into_bytes()));
    pack(lab.to_string().parse().unwrap(), &files.collect()).unwrap()
}

/// Makes a `.zip` of sources.
pub(crate) fn zip(lab: u8, files: &Files) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, text) in files {
        zip.start_file(format!("labs/lab{lab}/{path}"), SimpleFileOptions::DEFAULT).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}
