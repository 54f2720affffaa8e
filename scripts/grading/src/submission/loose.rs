//! Assigns files outside a folder labs/labN/src to a lab, if their names are unambiguous.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::names::{is_built, lab_of, parts};
use lab_kit::Lab;
use lab_kit::sources::{Sources, refused};

/// Folders of a kit that contain no work of a student.
const GIVEN: [&str; 4] = ["kept", "scripts", "solutions", "tests"];

/// A file's path and its contents.
pub(super) type Loose = (PathBuf, Vec<u8>);

/// Whether a file may be a source.
pub(super) fn may_be(path: &Path) -> bool {
    parts(path).is_ok_and(|parts| {
        !parts.iter().any(|part| GIVEN.contains(&part.as_str()) || is_built(part))
            && refused(&parts.join("/")).is_none()
    })
}

/// Finds the sources of a lab among loose files. Both sets are empty if a name is ambiguous.
///
/// Returns the sources, and the paths at which they were found.
pub(super) fn place(
    lab: Lab,
    tasks: &BTreeSet<String>,
    loose: &[Loose],
) -> (Sources, BTreeSet<PathBuf>) {
    let mut found = Found::default();
    let loose: Vec<&Loose> = loose.iter().filter(|(path, _)| !is_of_another(lab, path)).collect();
    let folders = source_folders(lab, tasks, &loose);
    match &folders[..] {
        [] => found.by_name(tasks, &loose),
        [folder] => found.add_folder(folder, &loose),
        _ => {}
    }
    (found.files, found.from)
}

/// Whether a file is in the folder of a different lab.
fn is_of_another(lab: Lab, path: &Path) -> bool {
    let parts = parts(path).unwrap_or_default();
    parts.iter().filter_map(|part| lab_of(part)).any(|of| of != lab)
}

/// Finds folders `src` that contain a file with a task. If there are several, only folders `src` of
/// the lab count.
fn source_folders(lab: Lab, tasks: &BTreeSet<String>, loose: &[&Loose]) -> Vec<String> {
    let mut folders: BTreeMap<String, bool> = BTreeMap::new();
    for (path, _) in loose {
        let parts = parts(path).unwrap_or_default();
        let Some(at) = parts.iter().rposition(|part| part == "src") else { continue };
        let is_labs = parts[..at].last().is_some_and(|folder| lab_of(folder) == Some(lab));
        if tasks.contains(&parts[at..].join("/")) {
            folders.insert(parts[..=at].join("/"), is_labs);
        }
    }
    if folders.values().any(|is_labs| *is_labs) {
        folders.retain(|_, is_labs| *is_labs);
    }
    folders.into_keys().collect()
}

#[derive(Default)]
struct Found {
    files: Sources,
    from: BTreeSet<PathBuf>,
}

impl Found {
    fn add(&mut self, to: String, (path, bytes): &Loose) {
        self.files.insert(to, bytes.clone());
        self.from.insert(path.clone());
    }

    /// Adds all files of a folder `src`.
    fn add_folder(&mut self, folder: &str, loose: &[&Loose]) {
        for file in loose {
            let path = parts(&file.0).unwrap_or_default().join("/");
            if let Some(below) = path.strip_prefix(folder).and_then(|rest| rest.strip_prefix('/')) {
                self.add(format!("src/{below}"), file);
            }
        }
    }

    /// Adds files that have the name of a file with a task, and the files beside them.
    fn by_name(&mut self, tasks: &BTreeSet<String>, loose: &[&Loose]) {
        for task in tasks {
            let name = Path::new(task).file_name();
            let alike = tasks.iter().filter(|other| Path::new(other).file_name() == name).count();
            // If several files with tasks have the same name, such as mod.rs, their folders
            // distinguish them.
            let end = if alike == 1 {
                Path::new(name.unwrap_or_default())
            } else {
                Path::new(&task[4..])
            };
            let named: Vec<&&Loose> =
                loose.iter().filter(|(path, _)| path.ends_with(end)).collect();
            match named[..] {
                [] => {}
                [file] => self.add(task.clone(), file),
                _ => return *self = Self::default(),
            }
        }
        let folders: BTreeSet<_> = self.from.iter().filter_map(|path| path.parent()).collect();
        let folders: Vec<PathBuf> = folders.into_iter().map(Path::to_owned).collect();
        let [folder] = &folders[..] else { return };
        for file in loose.iter().filter(|(path, _)| path.parent() == Some(folder)) {
            let name = file.0.file_name().unwrap_or_default().to_string_lossy();
            if !self.from.contains(&file.0) {
                self.add(format!("src/{name}"), file);
            }
        }
    }
}
