//! A class of submissions with their expected results.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::PathBuf;

use lab_kit::files::write_file;
use tempfile::TempDir;

use crate::cheats::{QUICK, TASK, TIMED};
use crate::expected::{EMPTY, Expected, Times, UNREADABLE};
use crate::solution::{Files, kit, solution, starter, tasks, with, wrong};
use crate::{archives, cheats};

/// Attacks that must fail. A successful attack reports itself and loses the marks.
const PAYLOAD: &str = include_str!("payload.rs");

/// Known-wrong solutions of the mixed class: a dozen, at least one for every task.
const WRONG: [&str; 12] = [
    "accelerations_pile_up",
    "reduction_race",
    "last_row_dropped",
    "rest_to_the_last",
    "rows_in_reverse",
    "bins_numbered_from_zero",
    "one_thread_moves",
    "lost_change_buffer",
    "bins_by_own_division",
    "mail_stays_in_the_box",
    "no_barrier_before_the_arrivals",
    "flag_raised_relaxed",
];

/// A folder of submissions.
pub(crate) struct Class {
    folder: TempDir,
    pub(crate) lab: u8,
    /// Names of submissions, and their expected results.
    pub(crate) members: Vec<(String, Expected)>,
}

/// Form of a submission.
#[derive(Clone, Copy)]
enum Form {
    Folder,
    Zip,
    Tar,
    /// An archive in a folder, as learning platforms export it.
    Upload,
}

impl Class {
    fn empty(lab: u8) -> Self {
        let class = Self { folder: tempfile::tempdir().unwrap(), lab, members: Vec::new() };
        for folder in [class.folder.path(), &class.folder(), &class.temporary()] {
            fs::create_dir_all(folder).unwrap();
            fs::set_permissions(folder, fs::Permissions::from_mode(0o755)).unwrap();
        }
        class
    }

    /// Makes a class of all cheats that are not about times, and of all unusual archives.
    pub(crate) fn of_cheats() -> Self {
        let mut class = Self::empty(QUICK);
        class.attacks();
        for (name, files, expected) in cheats::quick() {
            class.hand_in(&name, Form::Folder, &files, expected);
        }
        for (name, bytes, expected) in archives::all(QUICK) {
            fs::write(class.folder().join(name), bytes).unwrap();
            let stem = name.split('.').next().unwrap_or(name);
            class.members.push((stem.to_owned(), expected));
        }
        class.links();
        class
    }

    /// Makes a class of cheats against the clock, an untouched starter, and right and wrong
    /// submissions.
    pub(crate) fn mixed() -> Self {
        let mut class = Self::small(TIMED, &[]);
        for (name, files, expected) in cheats::timed().into_iter().chain(cheats::blinders()) {
            class.hand_in(&name, Form::Folder, &files, expected);
        }
        let forms = [Form::Zip, Form::Folder, Form::Tar].into_iter().cycle();
        for (name, form) in WRONG.into_iter().zip(forms) {
            class.with_wrong(name, form);
        }
        class
    }

    /// Makes a small class of an untouched starter, and right and wrong submissions.
    pub(crate) fn small(lab: u8, wrongs: &[&str]) -> Self {
        let mut class = Self::empty(lab);
        for (name, form) in [("solved", Form::Folder), ("solved-too", Form::Zip)] {
            class.hand_in(name, form, &solution(lab), Expected::full());
        }
        let expected = Expected::Graded { lost: tasks(lab), left_out: &[], times: Times::Nothing };
        class.hand_in("untouched", Form::Upload, &starter(lab), expected);
        wrongs.iter().for_each(|name| class.with_wrong(name, Form::Folder));
        class
    }

    /// Makes a class of one right submission.
    pub(crate) fn alone(lab: u8) -> Self {
        let mut class = Self::empty(lab);
        class.hand_in("solved", Form::Folder, &solution(lab), Expected::full());
        class
    }

    fn with_wrong(&mut self, name: &str, form: Form) {
        let (files, lost) = wrong(self.lab, name);
        let expected = Expected::Graded { lost, left_out: &[], times: Times::Any };
        self.hand_in(name, form, &files, expected);
    }

    /// Adds a link to all of the kit's solutions, and a folder whose sources are a link to a
    /// solution.
    fn links(&mut self) {
        let solutions = kit().join("solutions");
        let lab = format!("lab{}", self.lab);
        let linked = self.folder().join("linked/labs").join(&lab);
        fs::create_dir_all(&linked).unwrap();
        symlink(solutions.join(&lab).join("src"), linked.join("src")).unwrap();
        let nothing = Expected::ends(EMPTY, format!("no task's file in a folder labs/{lab}/src"));
        self.members.push(("linked".to_owned(), nothing));
        symlink(solutions, self.folder().join("link")).unwrap();
        self.members.push(("link".to_owned(), Expected::ends(UNREADABLE, "is a link")));
    }

    /// Returns the folder of submissions.
    pub(crate) fn folder(&self) -> PathBuf {
        self.folder.path().join("class")
    }

    /// Returns a folder for the output of the command.
    pub(crate) fn temporary(&self) -> PathBuf {
        self.folder.path().join("temporary")
    }

    /// Asserts that no archive wrote outside its folder.
    pub(crate) fn assert_nothing_escaped(&self) {
        for folder in [self.folder(), self.folder.path().to_owned(), self.temporary()] {
            assert!(!folder.join("escaped.rs").exists(), "{} was written to", folder.display());
        }
    }

    /// Adds a submission that runs every attack and contains unexpected files.
    fn attacks(&mut self) {
        let lab = self.lab;
        let mut files = with(lab, &[(TASK, "crate::payload::all();")]);
        files.insert("src/payload.rs".into(), PAYLOAD.into());
        files.get_mut("src/lib.rs").unwrap().push_str("\nmod payload;\n");
        let left_out = &["build.rs", ".cargo", ".config", "Cargo.toml", "its name is not UTF-8"];
        let expected = Expected::Graded { lost: Vec::new(), left_out, times: Times::Any };
        self.hand_in("attacks", Form::Folder, &files, expected);
        let runner = "[target.x86_64-unknown-linux-gnu]\nrunner = \"true\"\n\
                      [env]\nINSTA_UPDATE = \"always\"\nINSTA_FORCE_PASS = \"1\"\n";
        let manifest = format!("[package]\nname = \"lab{lab}\"\nbuild = \"build.rs\"\n");
        let own = self.folder().join("attacks");
        let below = own.join(format!("labs/lab{lab}"));
        for (path, text) in [
            (below.join("build.rs"), "fn main() { panic!(\"build.rs ran\"); }"),
            (below.join("Cargo.toml"), &manifest),
            (below.join(".cargo/config.toml"), runner),
            (own.join(".cargo/config.toml"), runner),
            (own.join(".config/nextest.toml"), "[profile.default]\n"),
            (below.join("src").join(OsStr::from_bytes(b"\xff\xfe.rs")), "nobody reads this"),
        ] {
            write_file(&path, text).unwrap();
        }
    }

    fn hand_in(&mut self, name: &str, form: Form, files: &Files, expected: Expected) {
        let own = self.folder().join(name);
        match form {
            Form::Folder => {
                let below = own.join(format!("labs/lab{}", self.lab));
                files.iter().for_each(|(path, text)| write_file(&below.join(path), text).unwrap());
            }
            Form::Zip => {
                write_file(&own.with_extension("zip"), archives::zip(self.lab, files)).unwrap();
            }
            Form::Tar => {
                write_file(&own.with_extension("tar.gz"), archives::tar(self.lab, files)).unwrap();
            }
            Form::Upload => {
                write_file(&own.join("lab.tar.gz"), archives::tar(self.lab, files)).unwrap();
                write_file(&own.join("comment.txt"), "please grade this").unwrap();
            }
        }
        self.members.push((name.to_owned(), expected));
    }
}
