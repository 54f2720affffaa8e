//! Where a path of a submission leads.

use std::path::{Component, Path};

use lab_kit::Lab;
use lab_kit::submission::{LeftOut, refused};

/// The lab that a path in an archive belongs to, and the path below that lab's folder. Anything with
/// `..`, an absolute path or an odd name leads nowhere.
pub(crate) fn resolve(path: &Path) -> Result<(Lab, String), LeftOut> {
    // Windows' own packers write its separators.
    let path = path.to_str().ok_or(LeftOut::Name)?.replace('\\', "/");
    let mut parts = Vec::new();
    for part in Path::new(&path).components() {
        match part {
            Component::Normal(part) => parts.push(part.to_str().unwrap_or_default()),
            Component::CurDir => {}
            _ => return Err(LeftOut::Outside),
        }
    }
    let source = || {
        let labs = parts.iter().take(2).position(|part| *part == "labs")?;
        let lab = lab_of(parts.get(labs + 1)?)?;
        let path = parts[labs + 2..].join("/");
        path.starts_with("src/").then_some((lab, path))
    };
    let (lab, path) = source().ok_or(LeftOut::Elsewhere)?;
    refused(&path).map_or(Ok((lab, path)), Err)
}

/// `lab3` is lab 3.
pub(crate) fn lab_of(name: &str) -> Option<Lab> {
    name.strip_prefix("lab")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{LeftOut, resolve};

    #[test]
    fn only_a_labs_sources_are_taken() {
        let source = |path: &str| Ok(("2".parse().unwrap(), path.into()));
        for (path, found) in [
            ("labs/lab2/src/lib.rs", source("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", source("src/a/b.rs")),
            ("own\\labs\\lab2\\src\\a\\b.rs", source("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", Err(LeftOut::Elsewhere)),
            ("labs/lab2/build.rs", Err(LeftOut::Elsewhere)),
            (".cargo/config.toml", Err(LeftOut::Elsewhere)),
            ("labs/common/src/lib.rs", Err(LeftOut::Elsewhere)),
            ("labs/lab2/src/../../../x.rs", Err(LeftOut::Outside)),
            ("labs/lab2/src\\..\\x.rs", Err(LeftOut::Outside)),
            ("/labs/lab2/src/lib.rs", Err(LeftOut::Outside)),
            ("labs/lab2/src/.cargo/config.toml", Err(LeftOut::Hidden)),
        ] {
            assert_eq!(resolve(Path::new(path)), found, "{path}");
        }
    }
}
