//! All letters in one archive, which can be uploaded to Moodle as the feedback files of an
//! assignment.
//!
//! Moodle finds the student by the folder's name, which must be the name in Moodle's export: `Ada
//! Lovelace_4711_assignsubmission_file`.

use std::io::{Cursor, Write};

use anyhow::Result;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Packs the letters of the submissions that Moodle exported.
///
/// `letters` contains pairs of a submission's name and its letter. The result is `None` if Moodle
/// exported no submission.
pub(super) fn archive(letters: &[(&str, String)]) -> Result<Option<Vec<u8>>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut packed = 0;
    for (name, letter) in letters {
        if is_exported(name) {
            zip.start_file(format!("{name}/feedback.md"), SimpleFileOptions::default())?;
            zip.write_all(letter.as_bytes())?;
            packed += 1;
        }
    }
    let bytes = zip.finish()?.into_inner();
    Ok((packed > 0).then_some(bytes))
}

/// Whether a submission has a name by which Moodle finds its student: the student's name, number,
/// and the plug-in that took the file, with underscores between them.
fn is_exported(name: &str) -> bool {
    let mut parts = name.splitn(5, '_').skip(1);
    let number = parts.next().unwrap_or_default();
    number.parse::<u64>().is_ok() && parts.next() == Some("assignsubmission") && parts.count() > 0
}

#[cfg(test)]
mod tests {
    use std::io::{Cursor, Read};

    use zip::ZipArchive;

    use super::archive;

    #[test]
    fn letters_go_to_the_folders_that_moodle_names() {
        let names = [
            "Ada Lovelace_4711_assignsubmission_file",
            "Zoë Müller_4712_assignsubmission_file_lab3",
            "Mary_Ann_assignsubmission_file",
            "ada",
        ];
        let letters = names.map(|name| (name, format!("Dear {name}")));
        let bytes = archive(&letters).unwrap().unwrap();
        let mut zip = ZipArchive::new(Cursor::new(bytes)).unwrap();
        assert_eq!(zip.len(), 2);
        for name in &names[..2] {
            let mut letter = String::new();
            let mut file = zip.by_name(&format!("{name}/feedback.md")).unwrap();
            file.read_to_string(&mut letter).unwrap();
            assert_eq!(letter, format!("Dear {name}"));
        }
    }

    #[test]
    fn without_an_export_of_moodle_there_is_no_archive() {
        assert!(archive(&[("ada", "Dear Ada".into())]).unwrap().is_none());
    }
}
