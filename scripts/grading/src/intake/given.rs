//! What is given is the kit's: a submission is its files with tasks, and new ones.
//!
//! A new file is a module, and is declared where modules are: often in a given file. So the kit's given
//! file declares it too. Nothing else that a student wrote there is compiled.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::Result;

use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab, answers, starter};

/// A lab's files as the kit gives them.
pub(crate) struct Given {
    /// Without a task.
    pub(super) files: Sources,
    /// With one: a student's.
    pub(crate) tasks: BTreeSet<String>,
}

impl Given {
    /// Those of a lab.
    pub(crate) fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        let marked = answers::read_solution(kit, lab)?.into_iter();
        let tasks = marked.filter(|file| file.regions().next().is_some());
        let tasks: BTreeSet<String> = tasks.map(|file| file.path.display().to_string()).collect();
        let files = starter::generate(kit, lab)?.into_iter();
        let files = files.map(|(path, bytes)| (path.display().to_string(), bytes));
        let is_given = |path: &str| path.starts_with("src/") && !tasks.contains(path);
        Ok(Self { files: files.filter(|(path, _)| is_given(path)).collect(), tasks })
    }

    /// Whether a file that is not below labs/ has the name of one with a task.
    pub(super) fn misplaced(&self, path: &Path) -> bool {
        let name = path.file_name();
        let is_task = self.tasks.iter().any(|task| Path::new(task).file_name() == name);
        is_task && !path.iter().any(|part| part == "labs")
    }

    /// Replaces a student's files by the kit's, and returns the paths of those whose code the
    /// student had changed.
    pub(super) fn put(&self, files: &mut Sources) -> Vec<String> {
        let is_new =
            |path: &&String| !self.files.contains_key(*path) && !self.tasks.contains(*path);
        let new: BTreeSet<String> = files.keys().filter(is_new).cloned().collect();
        let mut changed = Vec::new();
        for (path, bytes) in &self.files {
            let mut bytes = bytes.clone();
            if let Some(own) = files.get(path) {
                let (own, ours) = (String::from_utf8_lossy(own), String::from_utf8_lossy(&bytes));
                if !code(&own).eq(code(&ours)) {
                    changed.push(path.clone());
                }
                let declared = code(&own).filter_map(module).filter(|name| lies(path, name, &new));
                let declared: String = declared.map(|name| format!("mod {name};\n")).collect();
                bytes.extend(declared.into_bytes());
            }
            files.insert(path.clone(), bytes);
        }
        changed
    }
}

/// Lines of code: spaces around them, and whole lines of comments, are none.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"))
}

/// The module that a line declares.
fn module(line: &str) -> Option<&str> {
    let (visible, rest) = line.split_once("mod ")?;
    let plain = visible.is_empty() || visible.starts_with("pub");
    rest.strip_suffix(';').map(str::trim).filter(|_| plain)
}

/// Whether the file of a module that `path` declares is among the new ones.
fn lies(path: &str, module: &str, new: &BTreeSet<String>) -> bool {
    let path = Path::new(path);
    let is_root = ["lib.rs", "main.rs", "mod.rs"].iter().any(|root| path.ends_with(root));
    let folder =
        if is_root { path.parent().unwrap_or(path).to_owned() } else { path.with_extension("") };
    [format!("{module}.rs"), format!("{module}/mod.rs")]
        .iter()
        .any(|file| new.contains(&folder.join(file).display().to_string()))
}

#[cfg(test)]
mod tests {
    use super::Given;
    use lab_kit::submission::Sources;

    fn sources(files: &[(&str, &str)]) -> Sources {
        files.iter().map(|(path, text)| ((*path).into(), text.as_bytes().to_vec())).collect()
    }

    fn put(own: &[(&str, &str)]) -> (Sources, Vec<String>) {
        let files = sources(&[("src/lib.rs", "mod task;\n"), ("src/engine/mod.rs", "given();\n")]);
        let given = Given { files, tasks: ["src/task.rs".to_owned()].into() };
        let mut files = sources(own);
        let changed = given.put(&mut files);
        (files, changed)
    }

    #[test]
    fn a_given_file_is_the_kits_and_a_task_is_the_students() {
        let own = [("src/lib.rs", "// own\n  mod task;\r\n"), ("src/task.rs", "own();\n")];
        let (files, changed) = put(&own);
        assert_eq!(
            (&files["src/lib.rs"][..], &files["src/task.rs"][..]),
            (&b"mod task;\n"[..], &b"own();\n"[..])
        );
        assert_eq!(files["src/engine/mod.rs"], b"given();\n", "it need not be handed in");
        assert!(changed.is_empty(), "{changed:?}");
        let (files, changed) = put(&[("src/lib.rs", "mod task;\nfn cheat() {}\n")]);
        assert_eq!(
            (&files["src/lib.rs"][..], changed),
            (&b"mod task;\n"[..], vec!["src/lib.rs".to_owned()])
        );
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
        assert_eq!(files["src/lib.rs"], b"mod task;\nmod helper;\n");
        assert_eq!(files["src/engine/mod.rs"], b"given();\nmod deep;\n");
        assert_eq!(changed.len(), 2);
    }
}
