//! The tree that a submission is built in: a handout of its lab, with a probe.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, Result, bail};
use tempfile::TempDir;

use super::clean::clean;
use super::sandbox::{Sandbox, readable};
use super::{probe, rubric, timing};
use crate::handout;
use crate::harness::run_process;
use crate::kit::{Kit, Lab};
use crate::submission::Sources;

/// A build takes no longer; the first one compiles what the lab depends on.
const LIMIT: Duration = Duration::from_secs(300);

/// A tree for one submission after another.
pub(crate) struct Tree {
    folder: TempDir,
    lab: Lab,
    /// Whether there is a program to be timed.
    timed: bool,
}

/// What came of a build.
pub(crate) enum Built {
    /// A folder that holds the probe, and the program that is timed if there is one.
    Program(TempDir),
    /// What the compiler said, or that it took too long.
    Failed(String),
}

impl Tree {
    /// Lays a tree: no solution of `lab` or of a later one is in it.
    pub(crate) fn lay(kit: &Kit, lab: Lab) -> Result<Self> {
        let folder = tempfile::tempdir().context("cannot make a folder for builds")?;
        handout::lay(kit, lab, folder.path())?;
        strip(folder.path())?;
        let package = folder.path().join("labs/probe");
        fs::create_dir_all(package.join("src"))?;
        let rubric = rubric::read(kit, lab)?;
        let serial = rubric.scaling.is_some();
        let given = if serial { "solution2.workspace = true\n" } else { "" };
        let manifest = format!(
            "[package]\nname = \"probe\"\nedition.workspace = true\npublish = false\n\n\
             [dependencies]\ncommon.workspace = true\nlab{lab} = {{ path = \"../lab{lab}\" }}\n{given}"
        );
        fs::write(package.join("Cargo.toml"), manifest)?;
        for (from, to) in [(format!("lab{lab}.rs"), "lab.rs"), ("frame.rs".into(), "main.rs")] {
            let source = kit.path("tests/probes").join(from);
            fs::copy(&source, package.join("src").join(to))
                .with_context(|| format!("cannot read {}", source.display()))?;
        }
        if rubric.times_anything() {
            let timed = package.join("src/bin").join(timing::PROGRAM);
            fs::create_dir_all(&timed)?;
            for (to, from) in timing::sources(lab) {
                fs::copy(kit.path(from), timed.join(to))
                    .with_context(|| format!("cannot read {from}"))?;
            }
            let other = if serial { "solution2".into() } else { format!("lab{lab}") };
            let variants = format!(
                "pub use lab{lab}::VARIANTS as LAB;\npub use {other}::VARIANTS as SERIAL;\n"
            );
            fs::write(timed.join("variants.rs"), variants)?;
        }
        Ok(Self { folder, lab, timed: rubric.times_anything() })
    }

    /// Builds the probe with these sources behind it. Only the compiler runs: a submission brings
    /// no manifest, so no build script and no macro of its own.
    pub(crate) fn build(&self, sandbox: &Sandbox, sources: &Sources) -> Result<Built> {
        let root = self.folder.path();
        put(root, self.lab, sources)?;
        let names: &[&str] =
            if self.timed { &[probe::PROGRAM, timing::PROGRAM] } else { &[probe::PROGRAM] };
        let built = root.join("target/release");
        let mut cargo = sandbox.cargo(root);
        cargo.args(["build", "--quiet", "--offline", "--release", "--package", "probe"]);
        let finished = run_process(&mut cargo, LIMIT)?;
        match finished.status {
            None => return Ok(Built::Failed(format!("no build within {} s", LIMIT.as_secs()))),
            Some(status) if !status.success() => {
                return Ok(Built::Failed(finished.stderr.chars().take(4000).collect()));
            }
            Some(_) => {}
        }
        let folder = tempfile::tempdir()?;
        readable(folder.path())?;
        for name in names {
            fs::copy(built.join(name), folder.path().join(name))
                .with_context(|| format!("the build made no {name}"))?;
        }
        Ok(Built::Program(folder))
    }

    /// The solution's probe.
    pub(crate) fn reference(&self, kit: &Kit, sandbox: &Sandbox) -> Result<TempDir> {
        match self.build(sandbox, &solution(kit, self.lab)?)? {
            Built::Program(folder) => Ok(folder),
            Built::Failed(why) => bail!("the solution of lab {} cannot be built:\n{why}", self.lab),
        }
    }
}

/// Puts sources in the place of whatever was built before, of which nothing is left.
pub(super) fn put(root: &Path, lab: Lab, sources: &Sources) -> Result<()> {
    let name = format!("lab{lab}");
    clean(&root.join("target"), &[&name, probe::PROGRAM, timing::PROGRAM])?;
    let folder = root.join("labs").join(name);
    fs::remove_dir_all(folder.join("src"))?;
    fs::create_dir_all(folder.join("src"))?;
    for (path, bytes) in sources {
        let place = folder.join(path);
        fs::create_dir_all(place.parent().unwrap_or(&folder))?;
        fs::write(place, bytes)?;
    }
    Ok(())
}

/// Leaves nothing in a tree that a probe does not need: the graders have a model of their own, and
/// this command draws what the labs compute.
fn strip(root: &Path) -> Result<()> {
    for folder in ["book", "tests/oracle/src", "tests/snapshots", "scripts/src", "scripts/tests"] {
        let folder = root.join(folder);
        if folder.exists() {
            fs::remove_dir_all(folder)?;
        }
    }
    // The packages stay, since the workspace names them.
    for (file, text) in [("tests/oracle/src/lib.rs", ""), ("scripts/src/main.rs", "fn main() {}\n")]
    {
        let place = root.join(file);
        fs::create_dir_all(place.parent().unwrap_or(root))?;
        fs::write(place, text)?;
    }
    Ok(())
}

/// A solution as if it had been handed in: under the lab's own name.
pub(crate) fn solution(kit: &Kit, lab: Lab) -> Result<Sources> {
    let collected = crate::submission::collect(&kit.solution(lab))?;
    let mut sources = collected.files;
    for (path, bytes) in &mut sources {
        if PathBuf::from(path).extension().is_some_and(|extension| extension == "rs") {
            let text = String::from_utf8(std::mem::take(bytes)).context("a source is no text")?;
            *bytes = text.replace(&format!("solution{lab}::"), &format!("lab{lab}::")).into_bytes();
        }
    }
    Ok(sources)
}

/// What grading depends on: probes and solution. Not the rubric: marks can be made anew from
/// records.
pub(crate) fn graded_by(kit: &Kit, lab: Lab) -> Result<Sources> {
    let mut sources = solution(kit, lab)?;
    let probe = format!("tests/probes/lab{lab}.rs");
    let timed = timing::sources(lab).map(|(_, path)| path);
    for path in ["tests/probes/frame.rs", &probe].into_iter().chain(timed) {
        let bytes = fs::read(kit.path(Path::new(path)))
            .with_context(|| format!("cannot read {path}: lab {lab} cannot be graded"))?;
        sources.insert(path.to_owned(), bytes);
    }
    Ok(sources)
}
