//! Ensures that builds are made from the current sources.
//!
//! Cargo compares times: a package counts as built if no source is newer than the result. This
//! check fails if the sources have changed but are older than the result. Examples are an unpacked
//! archive, `cp -p`, a clock that was set back, and two clones with one build directory. So a hash
//! of the package's sources is kept beside each file that Cargo made from them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use anyhow::Result;
use serde::Deserialize;

use crate::files::{digest, read_bytes, sources_below};

/// Cargo's message about a file that it made, now or earlier.
#[derive(Deserialize)]
struct Artifact {
    package_id: String,
    manifest_path: PathBuf,
    filenames: Vec<PathBuf>,
    /// Whether the file existed already.
    fresh: bool,
}

/// Runs a Cargo command that prints its messages as JSON.
///
/// Packages that Cargo believed to be built, although their sources have changed, are built again.
///
/// # Errors
/// If Cargo does not start.
pub fn build(
    cargo: &mut Command,
    run: fn(&mut Command) -> io::Result<Output>,
) -> io::Result<Output> {
    let output = run(cargo)?;
    let stale = stale(cargo.get_current_dir(), &output);
    if stale.is_empty() {
        return Ok(output);
    }
    clean(cargo, &stale)?;
    let output = run(cargo)?;
    self::stale(cargo.get_current_dir(), &output);
    Ok(output)
}

/// Returns the packages in `root` whose compiled files were not made from the current sources.
///
/// For packages that are up to date, the function notes the hash of the sources.
fn stale(root: Option<&Path>, output: &Output) -> BTreeSet<String> {
    let root = root.and_then(|root| root.canonicalize().ok()).unwrap_or_default();
    let mut hashes = BTreeMap::new();
    let mut stale = BTreeSet::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(artifact) = serde_json::from_str::<Artifact>(line) else { continue };
        let Some(folder) = artifact.manifest_path.parent().filter(|at| at.starts_with(&root))
        else {
            continue;
        };
        let hash = hashes.entry(folder.to_owned()).or_insert_with(|| hash(folder).ok());
        let (Some(hash), Some(made)) = (hash, artifact.filenames.first()) else { continue };
        if artifact.fresh && !is_made_of(made, hash, folder, &root) {
            stale.insert(artifact.package_id);
        } else {
            note(made, hash);
        }
    }
    stale
}

/// Returns the hash of a package's files and their names.
fn hash(folder: &Path) -> Result<String> {
    let mut all = Vec::new();
    for path in sources_below(folder)? {
        all.extend(path.strip_prefix(folder)?.as_os_str().as_encoded_bytes());
        all.extend(digest(&read_bytes(&path)?).into_bytes());
    }
    Ok(digest(&all))
}

/// Whether Cargo made a file from the sources with this hash.
fn is_made_of(made: &Path, hash: &str, folder: &Path, root: &Path) -> bool {
    let Ok(metadata) = fs::metadata(made) else { return false };
    let noted = fs::read_to_string(beside(made)).unwrap_or_default();
    match noted.split_once(' ') {
        Some((of, identity)) if identity == self::identity(&metadata) => of == hash,
        // A different program, such as an editor, ran Cargo. In this kit's own build directory, the
        // program used these sources if no source was written later. The check uses the ctime of
        // the sources, because no program can set it back.
        _ => {
            let is_own = made.canonicalize().is_ok_and(|made| made.starts_with(root));
            is_own && !is_written_since(folder, &metadata)
        }
    }
}

fn is_written_since(folder: &Path, made: &fs::Metadata) -> bool {
    let when = (made.mtime(), made.mtime_nsec());
    let Ok(paths) = sources_below(folder) else { return true };
    paths.iter().any(|path| {
        fs::metadata(path).map_or(true, |file| (file.ctime(), file.ctime_nsec()) >= when)
    })
}

/// Notes the hash of the sources that a file was made from. A file without a note is made again.
fn note(made: &Path, hash: &str) {
    if let Ok(metadata) = fs::metadata(made) {
        let _ = fs::write(beside(made), format!("{hash} {}", identity(&metadata)));
    }
}

/// Returns a text that differs whenever a file is made again.
fn identity(made: &fs::Metadata) -> String {
    format!("{}.{:09} {}", made.mtime(), made.mtime_nsec(), made.len())
}

fn beside(made: &Path) -> PathBuf {
    let mut name = made.as_os_str().to_owned();
    name.push(".sources");
    name.into()
}

/// Removes the compiled files of these packages, in the profile of a command.
fn clean(cargo: &Command, packages: &BTreeSet<String>) -> io::Result<()> {
    let mut clean = Command::new(cargo.get_program());
    clean.args(["clean", "--quiet"]);
    clean.args(cargo.get_args().find(|argument| *argument == "--release"));
    clean.args(packages.iter().flat_map(|package| ["--package", package]));
    clean.current_dir(cargo.get_current_dir().unwrap_or(Path::new(".")));
    for (name, value) in cargo.get_envs() {
        match value {
            Some(value) => clean.env(name, value),
            None => clean.env_remove(name),
        };
    }
    clean.output().map(|_| ())
}

#[cfg(test)]
mod tests {
    use std::fs::{self, File};
    use std::path::{Path, PathBuf};
    use std::process::Command;
    use std::time::{Duration, SystemTime};

    use super::build;
    use crate::files::write_file;

    /// Writes a program that prints a number, with the given modification time.
    fn write(kit: &Path, number: u8, time: SystemTime) {
        write_file(&kit.join("Cargo.toml"), "[workspace]\nmembers = [\"p\"]\nresolver = \"3\"\n")
            .unwrap();
        let manifest = "[package]\nname = \"p\"\nedition = \"2024\"\n";
        write_file(&kit.join("p/Cargo.toml"), manifest).unwrap();
        let source = kit.join("p/src/main.rs");
        write_file(&source, format!("fn main() {{ print!(\"{number}\") }}\n")).unwrap();
        File::options().append(true).open(source).unwrap().set_modified(time).unwrap();
    }

    fn cargo(kit: &Path, target: &Path) -> Command {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["build", "--message-format=json"]).current_dir(kit);
        cargo.env("CARGO_TARGET_DIR", target).env_remove("CARGO_BUILD_BUILD_DIR");
        cargo
    }

    /// Builds the program, runs it, and returns its output.
    fn printed(kit: &Path, target: &Path) -> String {
        let output = build(&mut cargo(kit, target), Command::output).unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let ran = Command::new(target.join("debug/p")).output().unwrap();
        String::from_utf8(ran.stdout).unwrap()
    }

    /// Returns the time at which the program was made.
    fn time(target: &Path) -> SystemTime {
        fs::metadata(target.join("debug/p")).unwrap().modified().unwrap()
    }

    /// Makes a folder for kits.
    fn folder() -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().canonicalize().unwrap();
        (folder, path)
    }

    #[test]
    fn old_and_different_sources_are_built() {
        let (_folder, kit) = folder();
        let target = kit.join("target");
        write(&kit, 1, SystemTime::now());
        assert_eq!(printed(&kit, &target), "1");
        let built = time(&target);
        let hour = Duration::from_secs(3600);
        for (number, time) in [(2, SystemTime::UNIX_EPOCH), (3, built), (4, built - hour)] {
            write(&kit, number, time);
            assert_eq!(printed(&kit, &target), number.to_string());
        }
    }

    #[test]
    fn what_an_editor_built_is_not_taken_for_what_was_unpacked_since() {
        let (_folder, kit) = folder();
        let target = kit.join("target");
        write(&kit, 1, SystemTime::now());
        cargo(&kit, &target).output().unwrap();
        write(&kit, 2, SystemTime::UNIX_EPOCH);
        assert_eq!(printed(&kit, &target), "2");
    }

    #[test]
    fn two_clones_share_a_build_folder() {
        let (_folder, all) = folder();
        let clones = ["a", "b"].map(|name| all.join(name));
        let target = all.join("target");
        for (clone, number) in clones.iter().zip([1, 2]) {
            write(clone, number, SystemTime::UNIX_EPOCH);
        }
        for _ in 0..2 {
            for (clone, number) in clones.iter().zip(["1", "2"]) {
                assert_eq!(printed(clone, &target), number);
                // An editor builds without noting the hash.
                cargo(clone, &target).output().unwrap();
            }
        }
    }

    #[test]
    fn nothing_is_built_again_for_an_editors_file_or_a_new_time() {
        let (_folder, kit) = folder();
        let target = kit.join("target");
        write(&kit, 1, SystemTime::UNIX_EPOCH);
        printed(&kit, &target);
        let first = time(&target);
        write_file(&kit.join("p/src/.main.rs.swp"), "vim").unwrap();
        write_file(&kit.join("p/src/main.rs~"), "old").unwrap();
        write(&kit, 1, SystemTime::UNIX_EPOCH + Duration::from_secs(1));
        printed(&kit, &target);
        assert_eq!(time(&target), first);
    }
}
