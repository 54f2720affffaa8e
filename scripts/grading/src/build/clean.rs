//! Takes out of a tree what the build before left there of a submission, or of the solution:
//! `include_bytes!` reaches whatever is there.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Removes everything that was built of `packages` in `target`; what they depend on stays.
pub(crate) fn clean(target: &Path, packages: &[&str]) -> io::Result<()> {
    for profile in folder(target)? {
        for part in ["", "deps", ".fingerprint", "incremental", "build"] {
            for path in folder(&profile.join(part))? {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                if !packages.iter().any(|package| is_of(&name, package)) {
                    continue;
                }
                if path.is_dir() { fs::remove_dir_all(&path)? } else { fs::remove_file(&path)? }
            }
        }
    }
    Ok(())
}

/// `liblab1-0123abcd.rlib`, `lab1.d` and `lab1` are of lab1, and `lab10` is not.
fn is_of(file: &str, package: &str) -> bool {
    [file, file.strip_prefix("lib").unwrap_or(file)].iter().any(|name| {
        let rest = name.strip_prefix(package);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['-', '.']))
    })
}

fn folder(path: &Path) -> io::Result<Vec<std::path::PathBuf>> {
    match fs::read_dir(path) {
        Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => Ok(vec![]),
        entries => entries?.map(|entry| Ok(entry?.path())).collect(),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::clean;

    #[test]
    fn only_the_packages_themselves_go() {
        let folder = tempfile::tempdir().unwrap();
        let release = folder.path().join("release");
        let (gone, kept) = (
            [
                "deps/liblab1-ab.rlib",
                "deps/probe-ab",
                "probe",
                "liblab1.d",
                ".fingerprint/lab1-ab/x",
            ],
            ["deps/liblab10-ab.rlib", "deps/libcommon-ab.rlib", ".fingerprint/common-ab/x"],
        );
        for path in gone.iter().chain(&kept) {
            fs::create_dir_all(release.join(path).parent().unwrap()).unwrap();
            fs::write(release.join(path), "x").unwrap();
        }
        clean(folder.path(), &["lab1", "probe"]).unwrap();
        assert!(gone.iter().all(|path| !release.join(path).exists()));
        assert!(kept.iter().all(|path| release.join(path).exists()));
    }
}
