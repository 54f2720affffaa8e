//! Names of submissions and of the files in them.

use std::path::{Component, Path, PathBuf};

use unicode_normalization::UnicodeNormalization;

use lab_kit::Lab;
use lab_kit::sources::{NOT_UTF8, refused};

/// Name of the instructor's file about a class, beside the submissions.
pub(crate) const CLASS: &str = "class.toml";

/// Name of Gradescope's file about submissions, beside the submissions.
pub(crate) const METADATA: &str = "submission_metadata.yml";

/// Maximal number of bytes of a submission's name. File names contain this name, and pages show it.
const MOST: usize = 150;

/// Extensions of archives.
const ARCHIVES: [&str; 6] = [".tgz", ".gz", ".bz2", ".xz", ".tar", ".zip"];

/// Gives every submission a unique name. If two would have the same name, the second gets its full
/// file name.
pub(crate) fn named(paths: Vec<PathBuf>) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, PathBuf)> = Vec::new();
    for path in paths {
        let short = name(&path);
        let full = full(&path);
        let numbered = (2..).map(|number| format!("{full}-{number}"));
        let taken = |name: &String| named.iter().any(|(other, _)| other == name);
        let free = [short, full.clone()].into_iter().chain(numbered).find(|name| !taken(name));
        named.push((free.unwrap_or_default(), path));
    }
    named
}

/// Returns the name of a submission: its file's name without the extensions of archives.
pub(crate) fn name(path: &Path) -> String {
    bare(&full(path)).to_owned()
}

/// Removes from a name the extensions of archives, and the number of a repeated upload.
///
/// Examples are `ada.tar-1.gz`, `ada.tar (1).gz` and `ada (2).zip`, because browsers and platforms
/// add numbers in different places.
pub(crate) fn bare(name: &str) -> &str {
    let mut bare = name;
    while let Some(shorter) = without_ending(bare) {
        let copy = shorter.strip_suffix(')').and_then(|rest| rest.rsplit_once(" ("));
        let again = shorter.rsplit_once('-').filter(|(rest, _)| without_ending(rest).is_some());
        let numbered = copy.or(again).filter(|(_, number)| number.parse::<u16>().is_ok());
        bare = numbered.map_or(shorter, |(rest, _)| rest);
    }
    bare
}

fn without_ending(name: &str) -> Option<&str> {
    let lower = name.to_ascii_lowercase();
    let ending = ARCHIVES.iter().find(|ending| lower.ends_with(**ending))?;
    Some(&name[..name.len() - ending.len()]).filter(|rest| !rest.is_empty())
}

/// Whether a file has the name of an archive.
pub(super) fn is_called_archive(path: &Path) -> bool {
    without_ending(&path.file_name().unwrap_or_default().to_string_lossy()).is_some()
}

fn full(path: &Path) -> String {
    // The path `.` has no name, so the name of its folder is used.
    let canonical = path.canonicalize().unwrap_or_default();
    let name = path.file_name().or(canonical.file_name());
    let mut name = composed(&name.unwrap_or_default().to_string_lossy());
    name.truncate(name.floor_char_boundary(MOST));
    name
}

/// Returns a name with each accented letter as one character.
///
/// Most systems write names in this form. macOS writes the accent as a separate character, so names
/// are composed before they are compared.
pub(crate) fn composed(name: &str) -> String {
    name.nfc().collect()
}

/// Whether the packer of macOS made a file only to keep file properties of macOS.
pub(super) fn is_macos(path: &Path) -> bool {
    path.iter().any(|part| part == "__MACOSX")
}

/// Reason for leaving out a file that is not a source of a lab.
pub(super) const ELSEWHERE: &str = "not below labs/labN/src: grading has its own";

/// Maximal number of folders around a submission's labs/.
pub(super) const DEEP: usize = 8;

/// Returns the lab that a path in an archive belongs to, and the path below that lab's folder.
///
/// A path with `..`, an absolute path or an unusual name is refused.
pub(super) fn resolve(path: &Path) -> Result<(Lab, String), &'static str> {
    let parts = parts(path)?;
    let source = (0..parts.len().min(DEEP)).find_map(|at| {
        let [labs, lab, below @ ..] = &parts[at..] else { return None };
        let lab = lab_of(lab).filter(|_| labs == "labs" && !parts[..at].iter().any(is_built))?;
        Some((lab, below.join("/"))).filter(|(_, below)| below.starts_with("src/"))
    });
    let (lab, path) = source.ok_or(ELSEWHERE)?;
    if path.contains(char::REPLACEMENT_CHARACTER) {
        return Err(NOT_UTF8);
    }
    refused(&path).map_or(Ok((lab, path)), Err)
}

/// Splits a path into composed names. Bytes that are not UTF-8 become U+FFFD.
///
/// # Errors
/// If the path leads out of the submission.
pub(super) fn parts(path: &Path) -> Result<Vec<String>, &'static str> {
    // Packers on Windows write backslashes.
    let path = composed(&path.to_string_lossy().replace('\\', "/"));
    let mut parts = Vec::new();
    for part in Path::new(&path).components() {
        match part {
            Component::Normal(part) => parts.push(part.to_string_lossy().into_owned()),
            Component::CurDir => {}
            _ => return Err("its path leads out of the submission"),
        }
    }
    Ok(parts)
}

/// Whether a folder is hidden or Cargo's build directory. Both may contain copies of the labs.
pub(super) fn is_built(folder: impl AsRef<str>) -> bool {
    folder.as_ref().starts_with('.') || folder.as_ref() == "target"
}

/// Returns the number of a lab's folder: `lab3` is lab 3.
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
        let outside = "its path leads out of the submission";
        for (path, found) in [
            ("labs/lab2/src/lib.rs", Ok("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", Ok("src/a/b.rs")),
            ("own\\labs\\lab2\\src\\a\\b.rs", Ok("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", Err(ELSEWHERE)),
            ("labs/lab2/build.rs", Err(ELSEWHERE)),
            (".cargo/config.toml", Err(ELSEWHERE)),
            ("labs/common/src/lib.rs", Err(ELSEWHERE)),
            ("labs/lab2/src/../../../x.rs", Err(outside)),
            ("labs/lab2/src\\..\\x.rs", Err(outside)),
            ("/labs/lab2/src/lib.rs", Err(outside)),
            ("labs/lab2/src/.cargo/config.toml", Err("hidden, or an editor's copy")),
        ] {
            let found = found.map(|path: &str| ("2".parse().unwrap(), path.to_owned()));
            assert_eq!(resolve(Path::new(path)), found, "{path}");
        }
    }
}
