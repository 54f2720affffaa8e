//! What submissions are called.

use std::path::{Path, PathBuf};

/// Gives every submission a name of its own: whose name another has too is called in full.
pub(crate) fn named(paths: Vec<PathBuf>) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, PathBuf)> = Vec::new();
    for path in paths {
        let short = name(&path);
        let full = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let numbered = (2..).map(|number| format!("{full}-{number}"));
        let taken = |name: &String| named.iter().any(|(other, _)| other == name);
        let free = [short, full.clone()].into_iter().chain(numbered).find(|name| !taken(name));
        named.push((free.unwrap_or_default(), path));
    }
    named
}

/// What a submission is called: its file's name without the endings of archives.
pub(crate) fn name(path: &Path) -> String {
    let name = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let name = name.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let ending = [".tar.gz", ".tgz", ".zip"].into_iter().find(|ending| name.ends_with(ending));
    ending.map_or(name.clone(), |ending| name[..name.len() - ending.len()].to_owned())
}
