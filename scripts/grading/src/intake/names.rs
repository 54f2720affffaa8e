//! What submissions are called.

use std::path::{Path, PathBuf};

/// The most bytes of a name: files are called after it, and pages show it.
const MOST: usize = 150;

/// How the names of archives end.
pub(super) const ARCHIVES: [&str; 4] = [".tar.gz", ".tgz", ".tar", ".zip"];

/// Gives every submission a name of its own: whose name another has too is called in full.
pub(crate) fn named(paths: Vec<PathBuf>) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, PathBuf)> = Vec::new();
    for path in paths {
        let (short, full) = (name(&path), full(&path));
        let numbered = (2..).map(|number| format!("{full}-{number}"));
        let taken = |name: &String| named.iter().any(|(other, _)| other == name);
        let free = [short, full.clone()].into_iter().chain(numbered).find(|name| !taken(name));
        named.push((free.unwrap_or_default(), path));
    }
    named
}

/// What a submission is called: its file's name without the endings of archives.
pub(crate) fn name(path: &Path) -> String {
    let name = full(path);
    ARCHIVES.iter().find_map(|ending| name.strip_suffix(ending)).unwrap_or(&name).to_owned()
}

fn full(path: &Path) -> String {
    // `.` has no name but that of the folder which it is.
    let whole = || path.canonicalize().ok();
    let name =
        path.file_name().map(ToOwned::to_owned).or_else(|| Some(whole()?.file_name()?.into()));
    let mut name = name.unwrap_or_default().to_string_lossy().into_owned();
    name.truncate(name.floor_char_boundary(MOST));
    name
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn everybody_has_a_name_of_their_own_that_a_file_can_have() {
        let long = "\u{4f5c}".repeat(84);
        let paths = ["a/ada.zip", "a/ada.tgz", "b/ada.tgz", &long, &format!("{long}x")];
        let named = named(paths.map(Into::into).into());
        let names: Vec<&str> = named.iter().map(|(name, _)| name.as_str()).collect();
        let cut = "\u{4f5c}".repeat(50);
        assert_eq!(names, ["ada", "ada.tgz", "ada.tgz-2", &cut, &format!("{cut}-2")]);
    }
}
