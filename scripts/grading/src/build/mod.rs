//! The tree that a submission is built in: a handout of its lab, with a probe.

mod cache;
mod clean;

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};
use tempfile::TempDir;

use crate::intake::solution::solution;
use crate::sandbox::Sandbox;
use crate::{probe, timing};
use cache::{Cache, copy};
use clean::clean;
use lab_keep::handout;
use lab_kit::process::run as run_process;
use lab_kit::rubric;
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab, files_below};

/// The solution's build takes no longer: it compiles what the lab depends on.
const FIRST: Duration = Duration::from_secs(900);

/// A tree for one submission after another.
pub(crate) struct Tree {
    folder: TempDir,
    lab: Lab,
    /// Whether there is a program to be timed.
    timed: bool,
    cache: Cache,
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
    pub(crate) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        handout::lay(kit, lab, folder.path())?;
        strip(folder.path())?;
        let package = folder.path().join("labs/probe");
        fs::create_dir_all(package.join("src"))?;
        let rubric = rubric::read(kit, lab)?;
        let serial = rubric.scaling.is_some();
        let manifest = probe_manifest(&folder.path().join(format!("labs/lab{lab}")), lab, serial)?;
        fs::write(package.join("Cargo.toml"), manifest)?;
        for (path, name) in probe_sources(kit, lab)? {
            fs::copy(&path, package.join("src").join(name))
                .with_context(|| format!("cannot read {}", path.display()))?;
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
        fetch(folder.path());
        let cache = Cache::of(kit);
        cache.put_into(folder.path())?;
        Ok(Self { folder, lab, timed: rubric.times_anything(), cache })
    }

    /// Another one, with all that is built in this.
    pub(crate) fn copy(&self, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        copy(self.folder.path(), folder.path()).context("cannot copy a tree for builds")?;
        Ok(Self { folder, lab: self.lab, timed: self.timed, cache: self.cache.clone() })
    }

    /// Builds the probe with these sources behind it. Only the compiler runs: a submission brings
    /// no manifest, so no build script and no macro of its own.
    pub(crate) fn build(&self, sandbox: &Sandbox, sources: &Sources) -> Result<Built> {
        self.build_within(sandbox.limits().build, sandbox, sources)
    }

    fn build_within(&self, limit: Duration, sandbox: &Sandbox, sources: &Sources) -> Result<Built> {
        let root = self.folder.path();
        put(root, self.lab, sources)?;
        let names: &[&str] =
            if self.timed { &[probe::PROGRAM, timing::PROGRAM] } else { &[probe::PROGRAM] };
        let built = root.join("target/release");
        let mut cargo = sandbox.cargo(root);
        cargo.args(["build", "--quiet", "--offline", "--release", "--package", "probe"]);
        let finished = run_process(&mut cargo, limit)?;
        match finished.status {
            None => return Ok(Built::Failed(format!("no build within {} s", limit.as_secs()))),
            Some(status) if status.signal() == Some(9) => {
                return Ok(Built::Failed("its build needed more memory than it may have".into()));
            }
            Some(status) if !status.success() => {
                return Ok(Built::Failed(errors_first(&finished.stderr)));
            }
            Some(_) => {}
        }
        let folder = sandbox.folder()?;
        for name in names {
            fs::copy(built.join(name), folder.path().join(name))
                .with_context(|| format!("the build made no {name}"))?;
        }
        Ok(Built::Program(folder))
    }

    /// The solution's probe. What it depends on is kept for the next time.
    pub(crate) fn reference(&self, kit: &Kit, sandbox: &Sandbox) -> Result<TempDir> {
        let built = match self.build_within(FIRST, sandbox, &solution(kit, self.lab)?)? {
            Built::Program(folder) => folder,
            Built::Failed(why) => bail!("the solution of lab {} cannot be built:\n{why}", self.lab),
        };
        // Of the solution itself nothing is kept.
        put(self.folder.path(), self.lab, &Sources::new())?;
        self.cache.keep(self.folder.path())?;
        Ok(built)
    }
}

/// What the compiler complains of, before what it only warns of.
fn errors_first(said: &str) -> String {
    let (mut errors, mut others) = (String::new(), String::new());
    let mut is_error = false;
    for line in said.lines() {
        is_error = line.starts_with("error") || is_error && !line.starts_with("warning");
        let part = if is_error { &mut errors } else { &mut others };
        part.extend([line, "\n"]);
    }
    errors + &others
}

/// Downloads what the probe of a laid tree depends on, and this machine lacks: a build in the
/// sandbox has no network. To list the dependencies is to have them; if that fails, the build says
/// what is missing.
fn fetch(root: &Path) {
    let _ = Kit::at(root).cargo().args(["tree", "--package", probe::PROGRAM]).output();
}

/// Puts sources in the place of whatever was built before, of which nothing is left.
fn put(root: &Path, lab: Lab, sources: &Sources) -> Result<()> {
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

/// Leaves nothing in a tree that a probe does not need: the graders have a model of their own.
fn strip(root: &Path) -> Result<()> {
    for folder in ["book", "tests/oracle/src", "tests/snapshots"] {
        let folder = root.join(folder);
        if folder.exists() {
            fs::remove_dir_all(folder)?;
        }
    }
    // The package stays, since the workspace names it.
    fs::create_dir_all(root.join("tests/oracle/src"))?;
    Ok(fs::write(root.join("tests/oracle/src/lib.rs"), "")?)
}

/// The probe's files and what they are called in its package: the frame, what the labs share, and
/// the lab's own.
fn probe_sources(kit: &Kit, lab: Lab) -> Result<Vec<(PathBuf, String)>> {
    let (own, parts) = (format!("lab{lab}.rs"), format!("lab{lab}_"));
    let folder = kit.path("tests/probes");
    let files = files_below(&folder)?.into_iter().filter_map(|path| {
        let name = path.strip_prefix(&folder).ok()?.to_str()?.to_owned();
        match name.as_str() {
            "frame.rs" => Some((path, "main.rs".into())),
            other if other == own => Some((path, "lab.rs".into())),
            other if other.starts_with("lab") && !other.starts_with(&parts) => None,
            // What is timed lies in a folder of its own.
            other if other.contains('/') => None,
            _ => Some((path, name)),
        }
    });
    let files: Vec<_> = files.collect();
    ensure!(
        files.iter().any(|(_, name)| name == "lab.rs"),
        "there is no tests/probes/{own}: lab {lab} cannot be graded"
    );
    Ok(files)
}

/// The probe needs the lab and whatever the lab needs: their types go in and out.
fn probe_manifest(folder: &Path, lab: Lab, serial: bool) -> Result<String> {
    let text = fs::read_to_string(folder.join("Cargo.toml"))?;
    let (_, rest) = text.split_once("[dependencies]\n").context("the lab depends on nothing")?;
    let mut needs = rest.split("\n[").next().unwrap_or_default().to_owned();
    if serial && !needs.contains("solution2.") {
        needs.push_str("\nsolution2.workspace = true");
    }
    Ok(format!(
        "[package]\nname = \"probe\"\nedition.workspace = true\npublish = false\n\n\
         [dependencies]\nlab{lab} = {{ path = \"../lab{lab}\" }}\n{needs}\n"
    ))
}

/// What grading depends on: probes and solution. Not the rubric: marks can be made anew from
/// records.
pub(crate) fn graded_by(kit: &Kit, lab: Lab) -> Result<Sources> {
    let mut sources = solution(kit, lab)?;
    let probes = probe_sources(kit, lab)?.into_iter().map(|(path, _)| path);
    let timed = timing::sources(lab).into_iter().map(|(_, path)| kit.path(path));
    let paths: Vec<PathBuf> = probes.chain(timed).collect();
    for path in paths {
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let name = path.strip_prefix(kit.root())?.display().to_string();
        sources.insert(name, bytes);
    }
    Ok(sources)
}

#[cfg(test)]
mod tests {
    use super::errors_first;

    #[test]
    fn errors_stand_before_warnings() {
        let said = "warning: unused\n --> a.rs\n\nerror[E0425]: x\n --> b.rs\n\nwarning: dead\n";
        let sorted = "error[E0425]: x\n --> b.rs\n\nwarning: unused\n --> a.rs\n\nwarning: dead\n";
        assert_eq!(errors_first(said), sorted);
    }
}
