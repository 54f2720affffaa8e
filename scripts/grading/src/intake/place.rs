//! Where a path of a submission leads.

use std::path::{Component, Path};

use lab_kit::Lab;
use lab_kit::submission::{LeftOut, refused};

/// Where a file of a submission belongs.
#[derive(Debug, PartialEq)]
pub(crate) enum Place {
    /// To a lab, by its path below the lab's folder.
    Source(Lab, String),
    /// Nowhere.
    Out(LeftOut),
}

/// Where a path in an archive belongs. Anything with `..`, an absolute path or an odd name has no
/// place.
pub(crate) fn place(path: &Path) -> Place {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => match part.to_str() {
                // What one system calls a name is a path to another.
                Some(part) if part.contains('\\') => return Place::Out(LeftOut::Outside),
                Some(part) => parts.push(part),
                None => return Place::Out(LeftOut::Name),
            },
            Component::CurDir => {}
            _ => return Place::Out(LeftOut::Outside),
        }
    }
    let source = || {
        let labs = parts.iter().take(2).position(|part| *part == "labs")?;
        let lab = lab_of(parts.get(labs + 1)?)?;
        let path = parts[labs + 2..].join("/");
        path.starts_with("src/").then_some((lab, path))
    };
    match source() {
        None => Place::Out(LeftOut::Elsewhere),
        Some((lab, path)) => refused(&path).map_or(Place::Source(lab, path), Place::Out),
    }
}

/// `lab3` is lab 3.
pub(crate) fn lab_of(name: &str) -> Option<Lab> {
    name.strip_prefix("lab")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{LeftOut, Place, place};

    #[test]
    fn only_a_labs_sources_have_a_place() {
        let source = |path: &str| Place::Source("2".parse().unwrap(), path.into());
        for (path, found) in [
            ("labs/lab2/src/lib.rs", source("src/lib.rs")),
            ("./handed-in/labs/lab2/src/a/b.rs", source("src/a/b.rs")),
            ("labs/lab2/Cargo.toml", Place::Out(LeftOut::Elsewhere)),
            ("labs/lab2/build.rs", Place::Out(LeftOut::Elsewhere)),
            (".cargo/config.toml", Place::Out(LeftOut::Elsewhere)),
            ("labs/common/src/lib.rs", Place::Out(LeftOut::Elsewhere)),
            ("labs/lab2/src/../../../x.rs", Place::Out(LeftOut::Outside)),
            ("labs/lab2/src\\..\\x.rs", Place::Out(LeftOut::Outside)),
            ("/labs/lab2/src/lib.rs", Place::Out(LeftOut::Outside)),
            ("labs/lab2/src/.cargo/config.toml", Place::Out(LeftOut::Hidden)),
        ] {
            assert_eq!(place(Path::new(path)), found, "{path}");
        }
    }
}
