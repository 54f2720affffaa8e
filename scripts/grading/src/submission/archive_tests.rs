//! Tests of valid, unusual, damaged and malicious submissions.

use std::fs;
use std::io::{Cursor, Read, Write};
use std::os::unix::fs::symlink;

use anyhow::Result;
use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use zip::CompressionMethod;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::names::ELSEWHERE;
use super::{SHOWN, Submission, list, listed, nothing, read, take};
use lab_kit::sources::{COUNT_LIMIT, Sources, pack};
use lab_kit::{Given, Kit};

/// The name of an archive, and its bytes.
type Archive = (&'static str, Vec<u8>);

const PLAIN: SimpleFileOptions = SimpleFileOptions::DEFAULT;

/// Reads an archive as a submission of lab 1.
fn taken((name, bytes): &Archive) -> Result<Submission> {
    let class = tempfile::tempdir().unwrap();
    let path = class.path().join(name);
    fs::write(&path, bytes).unwrap();
    take(&Kit::find().unwrap(), "1".parse().unwrap(), &given(), &path)
}

/// Returns the description of a lab with one file that has a task.
fn given() -> Given {
    Given { tasks: ["src/lib.rs".to_owned()].into(), ..Given::default() }
}

/// Returns a student's sources.
fn own() -> Sources {
    ["src/lib.rs", "src/deep/own.rs"].map(|path| (path.into(), b"fn f() {}".to_vec())).into()
}

/// Returns a student's sources and additional empty files.
fn own_and(more: &[String]) -> Sources {
    own().into_iter().chain(more.iter().map(|path| (path.clone(), Vec::new()))).collect()
}

fn tar(files: &Sources) -> Vec<u8> {
    pack("1".parse().unwrap(), files).unwrap()
}

fn zip(files: &Sources, more: impl FnOnce(&mut ZipWriter<Cursor<Vec<u8>>>)) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, text) in files {
        let plain = PLAIN.compression_method(CompressionMethod::Deflated);
        zip.start_file(format!("labs/lab1/{path}"), plain).unwrap();
        zip.write_all(text).unwrap();
    }
    more(&mut zip);
    zip.finish().unwrap().into_inner()
}

fn plain_tar(files: &Sources) -> Vec<u8> {
    let mut bytes = Vec::new();
    GzDecoder::new(&tar(files)[..]).read_to_end(&mut bytes).unwrap();
    bytes
}

/// Makes an archive with 48 MiB of compiled files before the sources.
fn built() -> Vec<u8> {
    let mut all = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::fast()));
    let built = ("target/debug/lab1".to_owned(), vec![0; 48 << 20]);
    for (path, bytes) in [built]
        .into_iter()
        .chain(own().into_iter().map(|(path, b)| (format!("labs/lab1/{path}"), b)))
    {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        all.append_data(&mut header, path, &bytes[..]).unwrap();
    }
    all.into_inner().unwrap().finish().unwrap()
}

/// Makes an archive with two additional empty files, `aa.rs` and `bb.rs`, and replaces `aa` by
/// `name`.
fn renamed(name: &[u8; 2]) -> Vec<u8> {
    let mut bytes = zip(&own_and(&["src/aa.rs".into(), "src/bb.rs".into()]), |_| ());
    for at in 0..bytes.len() - 9 {
        if &bytes[at..at + 9] == b"src/aa.rs" {
            bytes[at + 4..at + 6].copy_from_slice(name);
        }
    }
    bytes
}

/// Makes a tar with one empty entry. The function `header` can change the entry's header freely.
fn tar_of(header: impl FnOnce(&mut tar::Header)) -> Vec<u8> {
    let mut of_one = tar::Header::new_gnu();
    of_one.set_path("labs/lab1/src/lib.rs").unwrap();
    of_one.set_size(0);
    header(&mut of_one);
    of_one.set_cksum();
    let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
    packed.write_all(of_one.as_bytes()).unwrap();
    packed.finish().unwrap()
}

fn add_odd(zip: &mut ZipWriter<Cursor<Vec<u8>>>) {
    for path in ["labs/lab1/build.rs", "labs/lab1/src/../../../../escaped.rs"] {
        zip.start_file(path, PLAIN).unwrap();
    }
    zip.add_symlink("labs/lab1/src/link.rs", "/etc/passwd", PLAIN).unwrap();
}

fn add_macos(zip: &mut ZipWriter<Cursor<Vec<u8>>>) {
    zip.start_file("__MACOSX/labs/lab1/src/._lib.rs", PLAIN).unwrap();
}

#[test]
fn what_does_not_belong_is_left_out_with_its_reason() {
    let long = ["a".repeat(300), "a/".repeat(2100), "a".repeat(8 << 20)];
    let long = long.map(|name| format!("src/{name}.rs"));
    let elsewhere = "grading has its own";
    let unfit = "longer than 200 bytes";
    let zeros = [("src/zeros.rs".to_owned(), vec![0; 64 << 20])];
    let zeros: Sources = own().into_iter().chain(zeros).collect();
    let cases: [(Archive, &[&str]); 12] = [
        (("a.tar.gz", tar(&own())), &[]),
        (("a.zip", zip(&own(), |_| ())), &[]),
        (("mac.zip", zip(&own(), add_macos)), &[]),
        (("a.tar", plain_tar(&own())), &[]),
        (("built.tar.gz", built()), &[elsewhere]),
        (
            ("odd.zip", zip(&own(), add_odd)),
            &[elsewhere, "leads out of the submission", "no plain file"],
        ),
        (("long.tar.gz", tar(&own_and(&long))), &[unfit; 3]),
        // A name in a zip has at most 65535 bytes.
        (("long.zip", zip(&own_and(&long[..2]), |_| ())), &[unfit; 2]),
        (("nul.zip", renamed(b"a\0")), &["a control character"]),
        (("latin.zip", renamed(b"\xff\xfe")), &["its name is not UTF-8"]),
        (("bomb.tar.gz", tar(&zeros)), &["more than 1 MiB"]),
        (("bomb.zip", zip(&zeros, |_| ())), &["more than 1 MiB"]),
    ];
    for (archive, reasons) in cases {
        let submission = taken(&archive).unwrap();
        let mut files = submission.files;
        files.remove("src/bb.rs");
        assert_eq!(files, own(), "{}", archive.0);
        assert_eq!(submission.left_out.len(), reasons.len(), "{}", archive.0);
        for (left, reason) in submission.left_out.iter().zip(reasons) {
            assert!(left.reason.contains(reason), "{}: {}", archive.0, left.reason);
            assert!(left.path.chars().count() <= SHOWN + 1, "nobody reads megabytes");
        }
    }
}

#[test]
fn a_link_instead_of_a_source_is_not_followed() {
    let link = tar_of(|header| {
        header.set_entry_type(tar::EntryType::Symlink);
        header.set_link_name(Kit::find().unwrap().path("solutions/lab1/src/lib.rs")).unwrap();
    });
    let submission = taken(&("links.tar.gz", link)).unwrap();
    assert!(submission.files.is_empty());
    assert_eq!(submission.left_out[0].reason, "no plain file");
}

#[test]
fn what_is_broken_or_means_harm_is_refused() {
    let [new_file, own_file] = ["src/a.rs", "src/lib.rs"]
        .map(|file| tar(&own_and(&[file.into(), format!("{file}/b.rs")])));
    let many: Vec<String> = (0..=COUNT_LIMIT).map(|number| format!("src/{number}.rs")).collect();
    let mut cut = tar(&own());
    cut.truncate(cut.len() / 2);
    let cases: [(Archive, &str); 10] = [
        (("twice.zip", renamed(b"bb")), "two files in it have the same name"),
        (("file-and-folder.tar.gz", new_file), "src/a.rs in it is a file and a folder"),
        (("below-a-file.tgz", own_file), "src/lib.rs in it is a file and a folder"),
        (("broken.tar.gz", b"no archive".to_vec()), "cannot be unpacked"),
        (("broken.zip", b"PK no archive".to_vec()), "cannot be unpacked"),
        (("cut-off.tar.gz", cut), "cannot be unpacked"),
        (("nothing.zip", Vec::new()), "nothing.zip is empty (0 bytes)"),
        (("what.rar", b"who knows".to_vec()), "neither a folder nor"),
        (("lie.tar.gz", tar_of(|header| header.set_size(1 << 40))), "larger than 256 MiB"),
        (("many.zip", zip(&own_and(&many), |_| ())), "more than 200 files"),
    ];
    for (archive, why) in cases {
        let error = taken(&archive).err().unwrap_or_else(|| panic!("{} is taken", archive.0));
        assert!(format!("{error:#}").contains(why), "{}: {error:#}", archive.0);
    }
}

#[test]
fn hidden_submissions_are_told_apart() {
    let class = tempfile::tempdir().unwrap();
    for name in [
        "ada.tar.gz",
        "__MACOSX",
        ".hidden.tar.gz",
        "submission_metadata.yml",
        "class.toml",
        "r.csv",
    ] {
        fs::write(class.path().join(name), "").unwrap();
    }
    let (found, hidden) = listed(class.path()).unwrap();
    assert_eq!(found, [class.path().join("ada.tar.gz")]);
    assert_eq!(hidden, [".hidden.tar.gz", "__MACOSX"].map(|name| class.path().join(name)));
}

#[test]
fn archives_beside_a_folder_labs_are_not_passed_over() {
    let class = tempfile::tempdir().unwrap();
    let kit = Kit::find().unwrap();
    fs::create_dir(class.path().join("labs")).unwrap();
    assert_eq!(list(&kit, class.path()).unwrap(), [class.path()]);
    fs::write(class.path().join("ada.zip"), "").unwrap();
    let error = list(&kit, class.path()).unwrap_err().to_string();
    assert!(error.contains("beside it 1 with an archive's name. If it is a class"), "{error}");
}

#[test]
fn a_file_that_is_no_archive_is_refused_before_anything_is_built() {
    let class = tempfile::tempdir().unwrap();
    let kit = Kit::find().unwrap();
    let path = class.path().join("essay.pdf");
    fs::write(&path, "an essay").unwrap();
    for path in [path.as_path(), "/dev/zero".as_ref()] {
        let error = list(&kit, path).unwrap_err().to_string();
        assert!(error.contains("is neither a folder nor an archive"), "{error}");
    }
}

#[test]
fn what_lies_elsewhere_gets_a_sentence_that_says_what_to_do() {
    let archive = zip(&Sources::new(), |zip| zip.start_file("lab2/src/lib.rs", PLAIN).unwrap());
    let submission = taken(&("a.zip", archive)).unwrap();
    let message = nothing("1".parse().unwrap(), &submission.left_out);
    assert!(
        submission.files.is_empty()
            && message.contains("but lab2/src/lib.rs. 'cargo lab submit 1'"),
        "{message}"
    );
}

#[test]
fn a_file_in_two_places_is_said_to_be_in_the_wrong_one() {
    let archive = zip(&Sources::new(), |zip| {
        for path in ["new/lib.rs", "old/lib.rs", "report.pdf"] {
            zip.start_file(path, PLAIN).unwrap();
        }
    });
    let left_out = taken(&("a.zip", archive)).unwrap().left_out;
    let reasons = left_out.iter().map(|left| left.reason.as_str()).collect::<Vec<_>>();
    let misplaced = "it is not in labs/lab1/src";
    assert_eq!(reasons, [misplaced, misplaced, ELSEWHERE]);
    let message = nothing("1".parse().unwrap(), &left_out);
    assert!(message.contains("in it, but new/lib.rs. 'cargo lab submit 1'"), "{message}");
}

#[test]
fn uploads_in_a_folder_are_unpacked() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["1", "2"].map(|lab| pack(lab.parse().unwrap(), &own()).unwrap());
    fs::write(folder.path().join("one.tar.gz"), first).unwrap();
    fs::write(folder.path().join("two.tgz"), &second).unwrap();
    fs::write(folder.path().join("comment.txt"), "hello").unwrap();
    let handed_in = read(folder.path()).unwrap();
    assert_eq!(handed_in.labs.into_values().collect::<Vec<_>>(), [own(), own()]);
    assert_eq!(handed_in.left_out, [("comment.txt".into(), ELSEWHERE)]);
    fs::write(folder.path().join("two again.tgz"), second).unwrap();
    let error = read(folder.path()).unwrap_err().to_string();
    assert!(error.contains("lab 2 is in more than one archive"), "{error}");
}

#[test]
fn a_link_is_no_submission() {
    let (class, kit, lab) =
        (tempfile::tempdir().unwrap(), Kit::find().unwrap(), "1".parse().unwrap());
    for target in [kit.path("solutions"), kit.path("tests/wrong/lab1.md")] {
        let link = class.path().join("ada");
        symlink(target, &link).unwrap();
        let error = take(&kit, lab, &given(), &link).err().unwrap().to_string();
        assert!(error.contains("ada is a link"), "{error}");
        fs::remove_file(link).unwrap();
    }
}
