//! The package that is built beside a submission: the answering, judging and timed programs.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::{asking, timing};
use lab_kit::files::{read_bytes, write_file};
use lab_kit::sources::Sources;
use lab_kit::{Discs, Facts, Kit, Lab, Workers, files_below};

/// Manifest and sources of the package, by their paths in it.
#[derive(Clone)]
pub(super) struct Programs {
    manifest: String,
    sources: Sources,
}

/// Names of the programs of a submission.
pub(super) const NAMES: [&str; 2] = [asking::ANSWER, timing::PROGRAM];

/// Package that a lab's tests need but its questions do not.
const ONLY_TESTS: &str = "insta";

impl Programs {
    /// Collects the programs of a lab, for a package beside the lab's `folder`.
    pub(super) fn of(kit: &Kit, lab: Lab, rubric: &Facts, folder: &Path) -> Result<Self> {
        let mut sources = Sources::new();
        for path in questions(kit, lab)? {
            let to = format!("src/questions/{}", path.strip_prefix(kit.path("tests"))?.display());
            sources.insert(to, read_bytes(&path)?);
        }
        for program in [asking::ANSWER, asking::JUDGE] {
            let text = format!(
                "#![allow(missing_docs, dead_code)]\n#[path = \"../questions/lab{lab}.rs\"]\nmod questions;\n\n\
                 fn main() {{\n    oracle::{program}(questions::QUESTIONS, questions::ask);\n}}\n"
            );
            sources.insert(format!("src/bin/{program}.rs"), text.into_bytes());
        }
        let timed = format!("src/bin/{}", timing::PROGRAM);
        for (to, from) in timed_sources(rubric) {
            sources.insert(format!("{timed}/{to}"), read_bytes(&kit.path(from))?);
        }
        sources.insert(format!("{timed}/scene.rs"), scene(lab, rubric).into_bytes());
        Ok(Self { manifest: manifest(folder, lab, has_serial(rubric))?, sources })
    }

    /// Puts empty programs into `package`.
    ///
    /// A submission therefore cannot include the real programs while it is compiled.
    pub(super) fn hide(&self, package: &Path) -> Result<()> {
        if package.exists() {
            fs::remove_dir_all(package)?;
        }
        for path in self.sources.keys().filter(|path| is_main(path)) {
            write_file(&package.join(path), b"fn main() {}")?;
        }
        write_file(&package.join("Cargo.toml"), self.manifest.as_bytes())
    }

    /// Puts the real programs into `package`.
    pub(super) fn show(&self, package: &Path) -> Result<()> {
        self.sources.iter().try_for_each(|(path, text)| write_file(&package.join(path), text))
    }
}

/// Whether a source contains the main function of a program.
fn is_main(path: &str) -> bool {
    path.ends_with("main.rs") || path.matches('/').count() == 2 && path.starts_with("src/bin/")
}

/// Returns the paths of a lab's questions.
fn questions(kit: &Kit, lab: Lab) -> Result<Vec<PathBuf>> {
    let sources = kit.test_sources(lab)?;
    ensure!(!sources.is_empty(), "there is no tests/lab{lab}.rs: lab {lab} cannot be graded");
    Ok(sources)
}

/// Writes the module that runs a timed program: the lab's program that the order names, or the
/// serial program.
fn scene(lab: Lab, rubric: &Facts) -> String {
    let mut modules = String::new();
    let mut run = String::from("None");
    for (discs, variants) in discs(rubric) {
        modules += &format!("mod {discs};\n");
        run += &format!(".or_else(|| {discs}::run(order, lab{lab}::{variants}, begin))");
    }
    if has_serial(rubric) {
        run = format!(
            "if order.serial {{ soft::run(order, solution2::VARIANTS, begin) }} else {{ {run} }}"
        );
    }
    format!(
        "{modules}\npub fn run(order: &crate::Order, begin: &dyn Fn()) -> Option<Vec<f64>> {{\n    {run}\n}}\n"
    )
}

/// Whether a lab's programs run beside the serial program.
fn has_serial(lab: &Facts) -> bool {
    lab.scaling.is_some() || lab.has_contest()
}

/// Returns the kinds of discs that a lab's programs simulate.
///
/// Each kind comes with the name of the lab's list of programs.
fn discs(lab: &Facts) -> Vec<(&'static str, &'static str)> {
    let own = if lab.discs == Discs::Hard { "hard" } else { "soft" };
    let hard = lab.programs.get("hard").map(|_| ("hard", "HARD_VARIANTS"));
    [(own, "VARIANTS")].into_iter().chain(hard).collect()
}

/// Returns the name of a file in the timed program, and its path in the kit.
fn timed(to: &str, from: &str) -> (String, String) {
    (to.to_owned(), format!("tests/timed/{from}"))
}

/// Returns the files of a lab's timed program: their names, and their paths in the kit.
fn timed_sources(lab: &Facts) -> Vec<(String, String)> {
    let team = if lab.workers == Workers::Ranks { "ranks.rs" } else { "alone.rs" };
    let mut sources = vec![timed("main.rs", "main.rs"), timed("team.rs", team)];
    let scenes = discs(lab).into_iter().map(|(discs, _)| format!("{discs}.rs"));
    sources.extend(scenes.map(|scene| timed(&format!("scene/{scene}"), &scene)));
    sources
}

/// Writes the manifest.
///
/// The package depends on the lab and on the dependencies of the questions. It also depends on the
/// lab's dependencies, because functions of the lab take and return their types.
fn manifest(folder: &Path, lab: Lab, serial: bool) -> Result<String> {
    let text = fs::read_to_string(folder.join("Cargo.toml"))?;
    let own = section(&text, "dependencies").context("the lab depends on nothing")?;
    let of_tests = section(&text, "dev-dependencies").context("the lab has no tests")?;
    let mut needs: Vec<&str> = own.lines().chain(of_tests.lines()).collect();
    needs.retain(|line| !line.starts_with(ONLY_TESTS) && !line.is_empty());
    if serial && !needs.iter().any(|line| line.starts_with("solution2.")) {
        needs.push("solution2.workspace = true");
    }
    Ok(format!(
        "[package]\nname = \"probe\"\nedition.workspace = true\npublish = false\n\n\
         [dependencies]\nlab{lab} = {{ path = \"../lab{lab}\" }}\n{}\n",
        needs.join("\n")
    ))
}

/// Returns the lines of a section of a manifest.
fn section<'a>(manifest: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = manifest.split_once(&format!("[{name}]\n"))?;
    rest.split("\n[").next()
}

/// Returns the paths of the programs' sources in the kit.
///
/// The sources are the questions, the snapshots, the oracle and the timed program.
pub(super) fn files(kit: &Kit, lab: Lab) -> Result<Vec<PathBuf>> {
    let mut files = questions(kit, lab)?;
    files.extend(kit.snapshots(lab)?);
    for package in ["tests/oracle", "tests/oracle-mpi"] {
        files.extend(files_below(&kit.path(package))?);
    }
    files.extend(timed_sources(&kit.facts(lab)?).into_iter().map(|(_, path)| kit.path(path)));
    Ok(files)
}
