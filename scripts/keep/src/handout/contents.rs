//! The files of a handout.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use anyhow::Result;

use super::Earlier;
use super::book;
use super::copied::{add, add_all};
use super::manifest::{fit, with_own_labs};
use lab_kit::command::families;
use lab_kit::files::{read_bytes, read_text};
use lab_kit::starter::{Files, GIVEN, Record, generate};
use lab_kit::{Facts, Kit, Lab, Workers};

/// Files in the top folder that are copied as they are. The README is written for students instead.
const TOP: [&str; 14] = [
    ".cargo/config.toml",
    ".config/nextest.toml",
    ".devcontainer/devcontainer.json",
    ".gitattributes",
    ".gitignore",
    ".helix/languages.toml",
    ".vscode/extensions.json",
    ".vscode/settings.json",
    ".vscode/tasks.json",
    ".zed/settings.json",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "rust-toolchain.toml",
    "rustfmt.toml",
];

/// Returns all files of a tree with these labs, by path.
pub(super) fn gather(kit: &Kit, labs: &[Lab], earlier: Earlier) -> Result<Files> {
    let mut files = Files::new();
    for path in TOP {
        add(kit, &mut files, &kit.path(path))?;
    }
    for &lab in labs {
        starter(kit, lab, &mut files)?;
        tests(kit, lab, &mut files)?;
    }
    for folder in given_folders(kit, labs, earlier)? {
        add_all(kit, &mut files, &folder)?;
    }
    add_all(kit, &mut files, &kit.path("tests/oracle"))?;
    if have_ranks(kit, labs)? {
        add_all(kit, &mut files, &kit.path("tests/oracle-mpi"))?;
    }
    for package in families(kit)?.into_iter().filter(|package| package.handout) {
        add_all(kit, &mut files, &kit.path(package.folder))?;
    }
    add(kit, &mut files, &kit.path("scripts/setup.sh"))?;
    // The lock file is copied as a whole; cargo removes the packages that the handout does not
    // need.
    add(kit, &mut files, &kit.path("Cargo.lock"))?;
    // The measuring commands show the published numbers beside their measurements.
    add(kit, &mut files, &kit.path("book/published.toml"))?;
    // `cargo lab contest` shows these measurements of the kit's engines.
    add(kit, &mut files, &kit.path("book/data/lab14-landmarks.json"))?;
    add_all(kit, &mut files, &kit.path("scripts/slurm"))?;
    // This script grades a class.
    files.remove(Path::new("scripts/slurm/grade.sh"));
    book::add_pages(kit, labs, earlier, &mut files)?;
    files.insert("README.md".into(), readme(kit, labs).into_bytes());
    files.insert("AGENTS.md".into(), include_bytes!("agents.md").into());
    let manifest = fit(&read_text(&kit.path("Cargo.toml"))?, files.keys().map(PathBuf::as_path))?;
    let manifest = match earlier {
        Earlier::Solutions => manifest,
        Earlier::Own => with_own_labs(&manifest, labs)?,
    };
    files.insert("Cargo.toml".into(), manifest.into_bytes());
    Ok(files)
}

/// Whether one of these labs runs on ranks.
fn have_ranks(kit: &Kit, labs: &[Lab]) -> Result<bool> {
    for &lab in labs {
        if kit.facts(lab)?.workers == Workers::Ranks {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Adds a lab's starter, even if the instructor has changed the lab's folder.
fn starter(kit: &Kit, lab: Lab, files: &mut Files) -> Result<()> {
    let folder = PathBuf::from(format!("labs/lab{lab}"));
    let given = generate(kit, lab)?;
    files.insert(folder.join(Record::NAME), Record::of(&given).to_text().into_bytes());
    for (path, bytes) in given {
        files.insert(folder.join(GIVEN).join(&path), bytes.clone());
        files.insert(folder.join(path), bytes);
    }
    let facts = read_bytes(&kit.solution(lab).join(Facts::FILE))?;
    files.insert(folder.join(Facts::FILE), facts);
    let page = kit.path(folder.join("README.md"));
    if page.is_file() { add(kit, files, &page) } else { Ok(()) }
}

/// Adds the tests of a lab and their snapshots.
fn tests(kit: &Kit, lab: Lab, files: &mut Files) -> Result<()> {
    let paths = kit.test_sources(lab)?.into_iter().chain(kit.snapshots(lab)?);
    paths.into_iter().try_for_each(|path| add(kit, files, &path))
}

/// Returns the folders that these labs build on, directly or through other folders.
///
/// They are packages of given code and solutions of earlier labs that the labs' manifests name. If
/// the labs build on the student's own work, the solutions of `labs` are not among them.
fn given_folders(kit: &Kit, labs: &[Lab], earlier: Earlier) -> Result<BTreeSet<PathBuf>> {
    let own: BTreeSet<PathBuf> = labs.iter().map(|lab| kit.solution(*lab)).collect();
    let mut given = BTreeSet::new();
    let mut unread: Vec<PathBuf> = labs.iter().map(|lab| kit.solution(*lab)).collect();
    while let Some(folder) = unread.pop() {
        let mut folders = kit.dependencies(&folder)?;
        folders.retain(|path| ["labs/", "solutions/"].iter().any(|top| path.starts_with(top)));
        for folder in folders.into_iter().map(|path| kit.path(path)) {
            let is_own = earlier == Earlier::Own && own.contains(&folder);
            if !is_own && given.insert(folder.clone()) {
                unread.push(folder);
            }
        }
    }
    Ok(given)
}

/// Returns the README for students.
fn readme(kit: &Kit, labs: &[Lab]) -> String {
    let last = labs.last().map_or_else(String::new, Lab::to_string);
    let rows: String =
        labs.iter().map(|lab| format!("| {lab} | {} |\n", kit.title(*lab))).collect();
    include_str!("readme.md").replace("LABS\n", &rows).replace("LAB", &last)
}
