//! What submissions and the files in them are called.

use std::path::{Component, Path, PathBuf};

use unicode_normalization::UnicodeNormalization;

use lab_kit::Lab;
use lab_kit::submission::{NOT_UTF8, refused};

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
    let mut name = composed(&name.unwrap_or_default().to_string_lossy());
    name.truncate(name.floor_char_boundary(MOST));
    name
}

/// A name with each accent in its letter, as most systems write it. macOS writes them apart, so both must be made the
/// same before names are compared.
pub(crate) fn composed(name: &str) -> String {
    name.nfc().collect()
}

/// Whether the packer of macOS made it, to keep what only macOS knows of files.
pub(super) fn is_macos(path: &Path) -> bool {
    path.iter().any(|part| part == "__MACOSX")
}

/// Why a file of a submission is not taken: it is no source of a lab.
pub(super) const ELSEWHERE: &str = "not below labs/labN/src: grading has its own";

/// The lab that a path in an archive belongs to, and the path below that lab's folder. Anything with
/// `..`, an absolute path or an odd name leads nowhere.
pub(super) fn resolve(path: &Path) -> Result<(Lab, String), &'static str> {
    // Windows' own packers write its separators.
    let path = composed(&path.to_str().ok_or(NOT_UTF8)?.replace('\\', "/"));
    let mut parts = Vec::new();
    for part in Path::new(&path).components() {
        match part {
            Component::Normal(part) => parts.push(part.to_str().unwrap_or_default()),
            Component::CurDir => {}
            _ => return Err("its path leads out of the submission"),
        }
    }
    let source = || {
        let labs = parts.iter().take(2).position(|part| *part == "labs")?;
        let lab = lab_of(parts.get(labs + 1)?)?;
        let path = parts[labs + 2..].join("/");
        path.starts_with("src/").then_some((lab, path))
    };
    let (lab, path) = source().ok_or(ELSEWHERE)?;
    refused(&path).map_or(Ok((lab, path)), Err)
}

/// `lab3` is lab 3.
pub(super) fn lab_of(name: &str) -> Option<Lab> {
    name.strip_prefix("lab")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{ELSEWHERE, named, resolve};

    #[test]
    fn everybody_has_a_name_of_their_own_that_a_file_can_have() {
        let long = "\u{4f5c}".repeat(84);
        let paths = ["a/ada.zip", "a/ada.tgz", "b/ada.tgz", &long, &format!("{long}x")];
        let named = named(paths.map(Into::into).into());
        let names: Vec<&str> = named.iter().map(|(name, _)| name.as_str()).collect();
        let cut = "\u{4f5c}".repeat(50);
        assert_eq!(names, ["ada", "ada.tgz", "ada.tgz-2", &cut, &format!("{cut}-2")]);
    }

    #[test]
    fn only_a_labs_sources_are_taken() {
        let source = |path: &str| Ok(("2".parse().unwrap(), path.into()));
        let outside = "its path leads out of the submission";
        for (path, found) in [
            ("labs/lab2/src/lib.rs", source("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", source("src/a/b.rs")),
            ("own\\labs\\lab2\\src\\a\\b.rs", source("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", Err(ELSEWHERE)),
            ("labs/lab2/build.rs", Err(ELSEWHERE)),
            (".cargo/config.toml", Err(ELSEWHERE)),
            ("labs/common/src/lib.rs", Err(ELSEWHERE)),
            ("labs/lab2/src/../../../x.rs", Err(outside)),
            ("labs/lab2/src\\..\\x.rs", Err(outside)),
            ("/labs/lab2/src/lib.rs", Err(outside)),
            ("labs/lab2/src/.cargo/config.toml", Err("hidden, or an editor's copy")),
        ] {
            assert_eq!(resolve(Path::new(path)), found, "{path}");
        }
    }
}
