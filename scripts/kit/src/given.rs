//! Given files belong to the kit: a submission consists of the files with tasks, and of new files.
//! The starter of an open lab is complete and has no gap to fill: there all files of the library
//! belong to the student.
//!
//! A new file is a module, and the module's declaration is often in a given file. So the
//! declaration is copied into the kit's own version of the given file. Nothing else that a student
//! wrote in a given file is compiled. The grader and `cargo lab check` both build the result of
//! [`Given::put`].

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use anyhow::Result;

use crate::kit::Kit;
use crate::lab::Lab;
use crate::sources::Sources;
use crate::starter::{self, todo};

/// The files that the kit gives for a lab.
#[derive(Debug, Default)]
pub struct Given {
    /// Other files in src/.
    pub files: Sources,
    /// Paths of the files in src/ that belong to the student.
    pub tasks: BTreeSet<String>,
    /// Manifest and tests.
    pub beside: Sources,
}

impl Given {
    /// Reads the given files of a lab.
    pub fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let mut given = Self::default();
        for (path, bytes) in starter::given(kit, lab)? {
            let path = path.display().to_string();
            if !path.starts_with("src/") {
                given.beside.insert(path, bytes);
            } else if String::from_utf8_lossy(&bytes).lines().any(|line| todo(line).is_some()) {
                given.tasks.insert(path);
            } else {
                given.files.insert(path, bytes);
            }
        }
        if given.tasks.is_empty() {
            let library = given.files.extract_if(.., |path, _| !path.starts_with("src/main"));
            given.tasks = library.map(|(path, _)| path).collect();
        }
        Ok(given)
    }

    /// Replaces a student's given files by the kit's. Returns the paths of files whose code the
    /// student had changed.
    pub fn put(&self, files: &mut Sources) -> Vec<String> {
        let mut new: BTreeSet<String> = files.keys().cloned().collect();
        new.retain(|path| !self.files.contains_key(path) && !self.tasks.contains(path));
        let mut changed = Vec::new();
        for (path, bytes) in &self.files {
            let mut bytes = bytes.clone();
            if let Some(own) = files.get(path) {
                let own = String::from_utf8_lossy(own);
                if !code(&own).eq(code(&String::from_utf8_lossy(&bytes))) {
                    changed.push(path.clone());
                }
                for module in modules(&own).iter().filter(|module| module.is_among(&new, path)) {
                    bytes.extend(format!("{};\n", module.declared).into_bytes());
                }
            }
            files.insert(path.clone(), bytes);
        }
        changed
    }
}

/// Returns the lines of code, trimmed, without blank lines and whole lines of comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"))
}

/// A module whose code is in a different file.
#[derive(Debug, PartialEq)]
struct Module {
    /// Declaration as the student wrote it, without the semicolon.
    declared: String,
    name: String,
    /// File that a `path` attribute names.
    path: Option<String>,
}

/// Returns the modules that a file declares.
fn modules(text: &str) -> Vec<Module> {
    let text = without_comments(text);
    let mut modules = Vec::new();
    for statement in text.split_inclusive([';', '{', '}']) {
        modules.extend(statement.strip_suffix(';').and_then(Module::read));
    }
    modules
}

fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('/') {
        kept += &rest[..at];
        rest = &rest[at..];
        let end = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else {
            kept.push('/');
            1
        };
        rest = &rest[end..];
    }
    kept + rest
}

impl Module {
    /// Parses the text before a semicolon; `None` if it declares no module.
    fn read(statement: &str) -> Option<Self> {
        // Attributes of the whole file precede its first module.
        let file =
            statement.rfind("#![").map_or(0, |at| at + statement[at..].find(']').unwrap_or(0) + 1);
        let declared = statement[file..].trim();
        let (before, name) = declared.rsplit_once(char::is_whitespace)?;
        let visible = before.trim_end().strip_suffix("mod")?.trim_end();
        if !(visible.is_empty() || visible.ends_with([']', ')']) || visible.ends_with("pub")) {
            return None;
        }
        let path = visible.split_once("#[path").and_then(|(_, rest)| rest.split('"').nth(1));
        let name = name.trim_start_matches("r#").to_owned();
        Some(Self { declared: declared.to_owned(), name, path: path.map(String::from) })
    }

    /// Whether the module's file is among the new files, if `from` declares it.
    fn is_among(&self, new: &BTreeSet<String>, from: &str) -> bool {
        let from = Path::new(from);
        let beside = from.parent().unwrap_or(from);
        let is_root = ["lib.rs", "main.rs", "mod.rs"].iter().any(|root| from.ends_with(root));
        let folder = if is_root { beside.to_owned() } else { from.with_extension("") };
        if let Some(path) = &self.path {
            return new.contains(&plain(&beside.join(path)));
        }
        let module = folder.join(&self.name);
        [module.with_extension("rs"), module.join("mod.rs")]
            .iter()
            .any(|file| new.contains(&plain(file)))
    }
}

/// Resolves `.` and `..` in a path.
fn plain(path: &Path) -> String {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(parts.pop()),
            Component::CurDir => {}
            part => parts.push(part),
        }
    }
    parts.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::Given;
    use crate::kit::Kit;
    use crate::sources::Sources;

    fn sources(files: &[(&str, &str)]) -> Sources {
        files.iter().map(|(path, text)| ((*path).into(), text.as_bytes().to_vec())).collect()
    }

    fn put(own: &[(&str, &str)]) -> (Sources, Vec<String>) {
        let files = sources(&[("src/lib.rs", "mod task;\n"), ("src/engine/mod.rs", "given();\n")]);
        let tasks = ["src/task.rs".to_owned()].into();
        let given = Given { files, tasks, ..Given::default() };
        let mut files = sources(own);
        let changed = given.put(&mut files);
        (files, changed)
    }

    #[test]
    fn a_given_file_is_the_kits_and_a_task_is_the_students() {
        let own = [("src/lib.rs", "// own\n  mod task;\r\n"), ("src/task.rs", "own();\n")];
        let (files, changed) = put(&own);
        assert_eq!(files["src/lib.rs"], b"mod task;\n");
        assert_eq!(files["src/task.rs"], b"own();\n");
        assert_eq!(files["src/engine/mod.rs"], b"given();\n", "it need not be handed in");
        assert!(changed.is_empty(), "{changed:?}");
        let (files, changed) = put(&[("src/lib.rs", "mod task;\nfn cheat() {}\n")]);
        assert_eq!(files["src/lib.rs"], b"mod task;\n");
        assert_eq!(changed, ["src/lib.rs"]);
    }

    #[test]
    fn an_open_lab_belongs_to_the_student() {
        let given = Given::of(&Kit::find().unwrap(), "14".parse().unwrap()).unwrap();
        assert!(given.tasks.iter().eq(["src/entry.rs", "src/lib.rs"]), "{:?}", given.tasks);
        assert!(given.files.keys().eq(["src/main.rs"]));
    }

    #[test]
    fn new_modules_are_declared_where_the_student_declared_them() {
        let lib = "mod task;\n#[macro_use]\npub(crate) mod helper;\nmod missing;\nmod engine;\n";
        let deep = "given();\nmod deep;\n";
        let own = [
            ("src/lib.rs", lib),
            ("src/helper.rs", ""),
            ("src/engine/mod.rs", deep),
            ("src/engine/deep/mod.rs", ""),
        ];
        let (files, changed) = put(&own);
        assert_eq!(files["src/lib.rs"], b"mod task;\n#[macro_use]\npub(crate) mod helper;\n");
        assert_eq!(files["src/engine/mod.rs"], b"given();\nmod deep;\n");
        assert_eq!(changed.len(), 2);
    }

    #[test]
    fn a_declaration_is_found_however_it_is_written() {
        for lib in [
            "mod task;\nmod own; // a comment\n",
            "mod task; mod own;\n",
            "#![allow(unused)]\n/* mod none; */ mod own ;mod task;\n",
            "mod task;\npub\nmod\nown;\n",
            "use a::{b, c};\nmod own;\n",
            "fn f() {}\npub(in crate) mod own;\n",
        ] {
            let (files, _) = put(&[("src/lib.rs", lib), ("src/own.rs", "")]);
            let text = String::from_utf8_lossy(&files["src/lib.rs"]).into_owned();
            let words: Vec<&str> = text.split_whitespace().collect();
            assert!(words.ends_with(&["mod", "own;"]), "{lib}: {text}");
        }
        let named = "#[path = \"deep/../other.rs\"]\nmod own;\n";
        let (files, _) = put(&[("src/lib.rs", named), ("src/other.rs", "")]);
        assert_eq!(files["src/lib.rs"], format!("mod task;\n{named}").into_bytes());
        for lib in
            ["#[path = \"../outside.rs\"] mod own;", "// mod own;", "let mod_own;", "xmod own;"]
        {
            let (files, _) = put(&[("src/lib.rs", lib), ("src/own.rs", "")]);
            assert_eq!(files["src/lib.rs"], b"mod task;\n", "{lib}");
        }
    }
}
