//! Where a path of a submission leads.

use std::path::{Component, Path};

use lab_kit::Lab;
use lab_kit::submission::{NOT_UTF8, refused};

/// Why a file of a submission is not taken: it is no source of a lab.
pub(super) const ELSEWHERE: &str = "not below labs/labN/src: grading has its own";

/// The lab that a path in an archive belongs to, and the path below that lab's folder. Anything with
/// `..`, an absolute path or an odd name leads nowhere.
pub(super) fn resolve(path: &Path) -> Result<(Lab, String), &'static str> {
    // Windows' own packers write its separators.
    let path = path.to_str().ok_or(NOT_UTF8)?.replace('\\', "/");
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

    use super::{ELSEWHERE, resolve};

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
