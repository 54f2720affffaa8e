//! The class: who cheats how, and what must come of it.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{Cursor, Write};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};

use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;
use tempfile::TempDir;
use zip::write::{SimpleFileOptions, ZipWriter};

/// What a cheat comes to.
pub(crate) enum Expected {
    /// Full marks for the solution that it is, and a reason for what was not taken.
    Full { left_out: &'static [&'static str] },
    /// These tasks, and no others.
    Loses(&'static [&'static str]),
    /// It does not come to marks.
    Ends { status: &'static str, message: &'static str },
}

use Expected::{Ends, Full, Loses};

impl Expected {
    /// How a record differs from it, if it does.
    pub(crate) fn differs(&self, record: &Value) -> Option<&'static str> {
        let holds = |field: &str, text: &str| record[field].to_string().contains(text);
        match self {
            Full { .. } if record["points"] != 100.0 => Some("not full marks"),
            Full { left_out } if !left_out.iter().all(|text| holds("left_out", text)) => {
                Some("a reason is missing")
            }
            Full { .. } => None,
            Loses(tasks) => {
                let all = record["tasks"].as_array().into_iter().flatten();
                let lost = all.filter(|task| task["passed"] == false);
                let lost = lost.filter_map(|task| task["id"].as_str());
                let right = record["status"] == "graded" && lost.eq(tasks.iter().copied());
                (!right).then_some("other marks")
            }
            Ends { status, .. } if record["status"] != *status => Some("another end"),
            Ends { message, .. } if !holds("message", message) => Some("another message"),
            Ends { .. } => (record["points"] != 0.0).then_some("marks"),
        }
    }
}

const UNREADABLE: &str = "unreadable";
const NOT_BUILT: &str = "not-built";

/// Every member of the class.
pub(crate) const CHEATS: &[(&str, Expected)] = &[
    // Those who run: attacks in vain, early ends, and what would go on for ever.
    (
        "attacks",
        Full {
            left_out: &["build.rs", ".cargo", ".config", "Cargo.toml", "its name is not UTF-8"],
        },
    ),
    ("exits", Loses(&["1.1", "1.2", "1.3", "1.4", "1.5"])),
    ("bombs", Loses(&["1.1", "1.3", "1.4"])),
    ("hangs", Loses(&["1.4", "1.5"])),
    ("hogs", Loses(&["1.5"])),
    // Those who take what is not theirs, and find that it is not there.
    ("passwd", Ends { status: NOT_BUILT, message: "/etc/passwd" }),
    ("snapshot", Ends { status: NOT_BUILT, message: "lab1__" }),
    ("solution", Ends { status: NOT_BUILT, message: "solution1" }),
    ("reach-out", Ends { status: NOT_BUILT, message: "solutions/lab1" }),
    ("reach-home", Ends { status: NOT_BUILT, message: "solutions/lab1" }),
    ("oracle", Ends { status: NOT_BUILT, message: "model.rs" }),
    ("constructor", Ends { status: NOT_BUILT, message: "link_section" }),
    ("environment", Ends { status: NOT_BUILT, message: "unsafe" }),
    // Archives.
    ("odd-zip", Full { left_out: &["no plain file", "leads out of the submission"] }),
    ("links", Ends { status: NOT_BUILT, message: "src/lib.rs" }),
    ("linked", Ends { status: "empty", message: "no labs/lab1/src" }),
    ("broken", Ends { status: UNREADABLE, message: "cannot be unpacked" }),
    ("broken-zip", Ends { status: UNREADABLE, message: "cannot be unpacked" }),
    ("bomb", Ends { status: UNREADABLE, message: "larger than 1 MiB" }),
    ("bomb-zip", Ends { status: UNREADABLE, message: "larger than 1 MiB" }),
    ("what.rar", Ends { status: UNREADABLE, message: "neither a folder nor" }),
];

/// Attacks that must fail. Whoever succeeds says so, and loses the marks.
const ATTACKS: &str = include_str!("attacks.rs");

const EXIT: &str = "std::process::exit(0);";

const FORGED: &str = r#"
    for word in std::env::args() {
        println!("@{word} exact|end|");
    }
    println!("test result: ok. 26 passed; 0 failed;");
    std::process::exit(0);"#;

const OWN_TIME: &str = r#"
    println!("Simulation Time = 0.000001 seconds for 1000 particles.");
    std::process::exit(0);"#;

const FORK_BOMB: &str = r#"
    loop {
        let own = std::process::Command::new("/proc/self/exe").args(std::env::args().skip(1)).spawn();
        std::mem::forget(own);
    }"#;

const ENDLESS_LOOP: &str = "loop { std::hint::spin_loop(); }";

const DEADLOCK: &str = r#"
    let lock = std::sync::Mutex::new(());
    let first = lock.lock();
    let second = lock.lock();
    drop((first, second));"#;

const ENDLESS_OUTPUT: &str = r#"loop { println!("{}", "nonsense ".repeat(1000)); }"#;

const MEMORY: &str = r#"
    let mut all = Vec::new();
    loop { all.push(vec![0u8; 256 << 20]); }"#;

/// The kit that is tested.
pub(crate) fn kit() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("scripts/ is in the kit")
}

/// A folder of submissions.
pub(crate) struct Class {
    folder: TempDir,
}

type Files = BTreeMap<String, String>;

impl Class {
    /// Everybody hands in.
    pub(crate) fn make() -> Self {
        let class = Self { folder: tempfile::tempdir().unwrap() };
        for folder in [class.folder.path(), &class.folder(), &class.temporary()] {
            fs::create_dir_all(folder).unwrap();
            fs::set_permissions(folder, fs::Permissions::from_mode(0o755)).unwrap();
        }
        class.who_run();
        class.who_take();
        class.who_send_archives();
        class
    }

    /// The folder of submissions.
    pub(crate) fn folder(&self) -> PathBuf {
        self.folder.path().join("class")
    }

    /// A folder for what the command writes.
    pub(crate) fn temporary(&self) -> PathBuf {
        self.folder.path().join("temporary")
    }

    /// No path of an archive led anywhere.
    pub(crate) fn assert_nothing_escaped(&self) {
        for folder in [self.folder(), self.folder.path().to_owned(), self.temporary()] {
            assert!(!folder.join("escaped.rs").exists(), "{} was written to", folder.display());
        }
    }

    fn who_run(&self) {
        let attack = "crate::attacks::all();";
        let mut files = with(&[("1.1", attack)]);
        files.insert("src/attacks.rs".into(), ATTACKS.into());
        files.get_mut("src/lib.rs").unwrap().push_str("\nmod attacks;\n");
        self.hand_in("attacks", &files);
        let runner = "[target.x86_64-unknown-linux-gnu]\nrunner = \"true\"\n\
                      [env]\nINSTA_UPDATE = \"always\"\nINSTA_FORCE_PASS = \"1\"\n";
        for (path, text) in [
            ("labs/lab1/build.rs", "fn main() { panic!(\"build.rs ran\"); }"),
            ("labs/lab1/Cargo.toml", "[package]\nname = \"lab1\"\nbuild = \"build.rs\"\n"),
            ("labs/lab1/.cargo/config.toml", runner),
            (".cargo/config.toml", runner),
            (".config/nextest.toml", "[profile.default]\n"),
        ] {
            write(&self.folder().join("attacks").join(path), text);
        }
        let odd = OsStr::from_bytes(b"labs/lab1/src/\xff\xfe.rs");
        write(&self.folder().join("attacks").join(odd), "nobody reads this");

        self.hand_in(
            "exits",
            &with(&[("1.1", EXIT), ("1.2", FORGED), ("1.4", OWN_TIME), ("1.5", EXIT)]),
        );
        self.hand_in("bombs", &with(&[("1.1", FORK_BOMB), ("1.4", ENDLESS_LOOP)]));
        self.hand_in("hangs", &with(&[("1.4", DEADLOCK), ("1.5", ENDLESS_OUTPUT)]));
        self.hand_in("hogs", &with(&[("1.5", MEMORY)]));
    }

    fn who_take(&self) {
        let snapshots = fs::read_dir(kit().join("tests/snapshots")).unwrap().flatten();
        let mut snapshots = snapshots.map(|entry| entry.file_name().into_string().unwrap());
        let snapshot = snapshots.find(|name| name.starts_with("lab1__")).unwrap();
        let answer = |path: &str| format!("#[path = \"{path}\"] mod stolen; stolen::f();");
        let own = kit().join("solutions/lab1/src/force.rs");
        for (name, code) in [
            ("passwd", "const _: &str = include_str!(\"/etc/passwd\");".to_owned()),
            (
                "snapshot",
                format!("const _: &str = include_str!(\"../../../tests/snapshots/{snapshot}\");"),
            ),
            ("solution", "if true { return solution1::pair_acceleration(d); }".to_owned()),
            ("reach-out", answer("../../../../../solutions/lab1/src/force.rs")),
            ("reach-home", answer(own.to_str().unwrap())),
            ("oracle", answer("../../../../../tests/oracle/src/model.rs")),
            (
                "constructor",
                "extern \"C\" fn early() { std::process::exit(0); }\n\
                 #[unsafe(link_section = \".init_array\")] #[used]\n\
                 static EARLY: extern \"C\" fn() = early;"
                    .to_owned(),
            ),
            (
                "environment",
                "unsafe { std::env::set_var(\"INSTA_FORCE_PASS\", \"1\") };".to_owned(),
            ),
        ] {
            self.hand_in(name, &with(&[("1.1", &code)]));
        }
    }

    fn who_send_archives(&self) {
        let put = |name: &str, bytes: &[u8]| fs::write(self.folder().join(name), bytes).unwrap();
        let plain =
            SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);

        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        for (path, text) in solution() {
            zip.start_file(format!("labs/lab1/{path}"), plain).unwrap();
            zip.write_all(text.as_bytes()).unwrap();
        }
        zip.start_file("labs/lab1/src/../../../../escaped.rs", plain).unwrap();
        zip.add_symlink("labs/lab1/src/link.rs", "/etc/passwd", plain).unwrap();
        put("odd-zip.zip", zip.finish().unwrap().get_ref());

        let mut tar = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::fast()));
        let mut header = tar::Header::new_gnu();
        header.set_entry_type(tar::EntryType::Symlink);
        header.set_size(0);
        let own = kit().join("solutions/lab1/src/lib.rs");
        tar.append_link(&mut header, "labs/lab1/src/lib.rs", own).unwrap();
        let mut header = tar::Header::new_gnu();
        header.set_size(1);
        tar.append_data(&mut header, "labs/lab1/src/force.rs", &b" "[..]).unwrap();
        put("links.tar.gz", &tar.into_inner().unwrap().finish().unwrap());

        let linked = self.folder().join("linked/labs/lab1");
        fs::create_dir_all(&linked).unwrap();
        symlink(kit().join("solutions/lab1/src"), linked.join("src")).unwrap();

        put("broken.tar.gz", b"no archive");
        put("broken-zip.zip", b"PK no archive");
        put("what.rar", b"who knows");

        let zeros = vec![0; 64 << 20];
        let mut tar = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::fast()));
        let mut header = tar::Header::new_gnu();
        header.set_size(zeros.len() as u64);
        tar.append_data(&mut header, "labs/lab1/src/lib.rs", &zeros[..]).unwrap();
        put("bomb.tar.gz", &tar.into_inner().unwrap().finish().unwrap());
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        zip.start_file("labs/lab1/src/lib.rs", plain).unwrap();
        zip.write_all(&zeros).unwrap();
        put("bomb-zip.zip", zip.finish().unwrap().get_ref());
    }

    fn hand_in(&self, name: &str, files: &Files) {
        for (path, text) in files {
            write(&self.folder().join(name).join("labs/lab1").join(path), text);
        }
    }
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    File::create(path).unwrap().write_all(text.as_bytes()).unwrap();
}

/// The sources of the solution, by their path in the lab's folder, under the lab's own name.
fn solution() -> Files {
    let folder = kit().join("solutions/lab1/src");
    let files = fs::read_dir(folder).unwrap().flatten().map(|entry| {
        let text = fs::read_to_string(entry.path()).unwrap().replace("solution1::", "lab1::");
        (format!("src/{}", entry.file_name().into_string().unwrap()), text)
    });
    files.collect()
}

/// The solution with code before the answers of some tasks.
fn with(code: &[(&str, &str)]) -> Files {
    let mut files = solution();
    for (task, code) in code {
        let mark = format!("// task {task}: ");
        let file = files.values_mut().find(|text| text.contains(&mark)).expect("there is the task");
        let begin = file.find(&mark).unwrap();
        file.insert_str(begin, &format!("#[allow(unreachable_code)]\n{{\n{code}\n}}\n"));
    }
    files
}
