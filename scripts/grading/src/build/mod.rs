//! The tree that a submission is built in: a handout of its lab, with the programs that ask it.

#[cfg(test)]
mod answers;
mod cache;
mod programs;

use std::fs::{self, File, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use anyhow::{Context, Result, anyhow, bail, ensure};
use tempfile::TempDir;

use crate::asking;
use crate::sandbox::faults::{believed, named};
use crate::sandbox::{BUILD_QUOTA, BUILT_FILE, GIVEN_FILE, Sandbox};
use lab_keep::handout;
use lab_kit::files::{read_bytes, write_file};
use lab_kit::process::run as run_process;
use lab_kit::rubric;
use lab_kit::submission::{Sources, of_solution};
use lab_kit::{Kit, Lab, files_below};
use programs::{NAMES, Programs};

/// The solution's build takes no longer: it compiles what the lab depends on.
const FIRST: Duration = Duration::from_secs(900);

/// The beginning of what is said of a build that was not done in time.
const LATE: &str = "no build within";

/// The package of the programs that ask a submission, and its folder in a tree.
const PROBE: &str = "probe";
const PACKAGE: &str = "labs/lab-probe";

/// A tree for one submission after another.
pub(crate) struct Tree {
    folder: TempDir,
    lab: Lab,
    programs: Programs,
    /// What builds on a machine that works.
    solution: Sources,
}

/// What is built: sources, names of programs, and the time and bytes of a file that it may take.
#[derive(Clone, Copy)]
struct Order<'a> {
    sources: &'a Sources,
    names: &'a [&'a str],
    limit: Duration,
    most: u64,
}

impl<'a> Order<'a> {
    fn of_submission(sandbox: &Sandbox, sources: &'a Sources) -> Self {
        Self { sources, names: &NAMES, limit: sandbox.limits.build, most: BUILT_FILE }
    }
}

/// A folder of the programs that were built; or what the compiler said, or that it took too long.
type Built = std::result::Result<TempDir, String>;

impl Tree {
    /// Lays a tree: no solution of `lab` or of a later one is in it.
    pub(crate) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        handout::lay(kit, lab, folder.path())?;
        strip(folder.path(), lab)?;
        let own = folder.path().join(format!("labs/lab{lab}"));
        let programs = Programs::of(kit, lab, &rubric::read(kit, lab)?, &own)?;
        programs.hide(&folder.path().join(PACKAGE))?;
        fetch(folder.path());
        cache::put_into(&cache::of(kit), folder.path())?;
        Ok(Self { folder, lab, programs, solution: of_solution(kit, lab)? })
    }

    /// Another one, with all that is built in this.
    pub(crate) fn copy(&self, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        cache::copy(self.folder.path(), folder.path()).context("cannot copy a tree for builds")?;
        let (programs, solution) = (self.programs.clone(), self.solution.clone());
        Ok(Self { folder, lab: self.lab, programs, solution })
    }

    /// Builds the programs of a submission with these sources. Only the compiler runs: a submission brings
    /// no manifest, so no build script and no macro of its own.
    ///
    /// # Errors
    /// The solution cannot be built now either: that is no submission's mistake.
    pub(crate) fn build(&self, sandbox: &Sandbox, sources: &Sources) -> Result<Built> {
        believed(
            || self.build_once(sandbox, &Order::of_submission(sandbox, sources)),
            |built| built.as_ref().is_err_and(|why| !is_of_a_source(why)),
            || self.build_solution(sandbox),
        )
    }

    /// Builds the solution in the place of a submission.
    fn build_solution(&self, sandbox: &Sandbox) -> Result<()> {
        match self.build_once(sandbox, &Order::of_submission(sandbox, &self.solution))? {
            Ok(_) => Ok(()),
            Err(why) => bail!("the solution cannot be built either: {}", named(&why)),
        }
    }

    /// First the submission, with nothing of our programs in reach; then these, with nothing of the
    /// submission but what the compiler made of it.
    fn build_once(&self, sandbox: &Sandbox, order: &Order<'_>) -> Result<Built> {
        let (root, until) = (self.folder.path(), Instant::now() + order.limit);
        let Order { sources, names, .. } = *order;
        self.programs.hide(&root.join(PACKAGE))?;
        put(root, self.lab, sources, sandbox)?;
        if let Some(why) = compile(root, sandbox, order, until, "human")? {
            return Ok(Err(why));
        }
        empty(root, self.lab, sources)?;
        self.programs.show(&root.join(PACKAGE))?;
        clean(root, &[PROBE], sandbox)?;
        // In short, because nobody is to read a line of the questions.
        if let Some(why) = compile(root, sandbox, order, until, "short")? {
            let what = "it compiles, but not together with what asks it";
            return Ok(Err(format!("{what}:\n{why}")));
        }
        let folder = sandbox.folder()?;
        for name in names {
            fs::copy(root.join("target/release").join(name), folder.path().join(name))
                .with_context(|| format!("the build made no {name}"))?;
        }
        Ok(Ok(folder))
    }

    /// Bytes of the tree on its disk, and of what one more build adds to it.
    pub(crate) fn room(&self) -> Result<u64> {
        let mut bytes = BUILD_QUOTA;
        for path in files_below(self.folder.path())? {
            bytes += 512 * fs::symlink_metadata(path)?.blocks();
        }
        Ok(bytes)
    }

    /// The solution's programs, and the one that judges. What they depend on is kept for the next time.
    pub(crate) fn reference(&self, kit: &Kit, sandbox: &Sandbox) -> Result<TempDir> {
        let unbuilt = || format!("the solution of lab {} cannot be built", self.lab);
        let names = &[&NAMES[..], &[asking::JUDGE]].concat();
        let order = Order { sources: &self.solution, names, limit: FIRST, most: GIVEN_FILE };
        let built = self.build_once(sandbox, &order).with_context(unbuilt)?;
        let built = built.map_err(|why| anyhow!("{}:\n{why}", unbuilt()))?;
        // It knows what is right, and nobody who is asked may look into it.
        fs::set_permissions(built.path().join(asking::JUDGE), Permissions::from_mode(0o700))?;
        // Of the solution itself nothing is kept.
        put(self.folder.path(), self.lab, &Sources::new(), sandbox)?;
        cache::keep(&cache::of(kit), self.folder.path())?;
        // The oracle is compiled now, and no submission is to include its source.
        for path in files_below(&self.folder.path().join("tests"))? {
            if path.extension().is_some_and(|extension| extension == "rs") {
                File::create(&path)?.set_modified(SystemTime::UNIX_EPOCH)?;
            }
        }
        Ok(built)
    }
}

/// Compiles the programs of the sources that are in a tree; returns why it cannot.
fn compile(
    root: &Path,
    sandbox: &Sandbox,
    order: &Order<'_>,
    until: Instant,
    format: &str,
) -> Result<Option<String>> {
    let mut cargo = sandbox.cargo(root, order.most);
    cargo.args(["build", "--quiet", "--offline", "--release", "--package", PROBE]);
    cargo.args(order.names.iter().flat_map(|name| ["--bin", *name]));
    cargo.args(["--message-format", format]);
    let finished = run_process(&mut cargo, until.saturating_duration_since(Instant::now()))?;
    Ok(match finished.status {
        None => Some(format!("{LATE} {} s", order.limit.as_secs())),
        Some(status) if status.signal() == Some(9) => {
            Some("its build needed more memory than it may have".into())
        }
        Some(status) if status.success() => None,
        Some(_) if finished.stderr.contains("SIGXFSZ") => Some(format!(
            "its build made a larger file than the {} MiB that it may make: a constant or a static is too large",
            order.most >> 20
        )),
        Some(_) => Some(finished.stderr),
    })
}

/// Whether a build failed because of the sources: it took too long, or an error has a place in one.
fn is_of_a_source(why: &str) -> bool {
    why.starts_with(LATE) || why.lines().any(names_a_place)
}

/// Whether a line of the compiler's is `--> src/lib.rs:3:5` or `src/lib.rs:3:5: error`.
fn names_a_place(line: &str) -> bool {
    let mut parts = line.split(": error").next().unwrap_or_default().rsplit(':');
    let mut is_number = || parts.next().is_some_and(|part| part.parse::<u32>().is_ok());
    line.trim_start().starts_with("--> ") || is_number() && is_number()
}

/// Downloads what the programs of a laid tree depend on, and this machine lacks: a build in the
/// sandbox has no network. To list the dependencies is to have them; if that fails, the build says
/// what is missing.
fn fetch(root: &Path) {
    let _ = Kit::at(root).cargo().args(["tree", "--package", PROBE]).output();
}

/// Replaces the sources that were built before, of which nothing is left.
fn put(root: &Path, lab: Lab, sources: &Sources, sandbox: &Sandbox) -> Result<()> {
    let name = format!("lab{lab}");
    clean(root, &[&name, PROBE], sandbox)?;
    let folder = root.join("labs").join(name);
    fs::remove_dir_all(folder.join("src"))?;
    fs::create_dir_all(folder.join("src"))?;
    for (path, bytes) in sources {
        write_file(&folder.join(path), bytes)?;
    }
    Ok(())
}

/// Removes what was built of packages; what they depend on stays. `include_bytes!` would reach it.
fn clean(root: &Path, packages: &[&str], sandbox: &Sandbox) -> Result<()> {
    let mut cargo = sandbox.cargo(root, GIVEN_FILE);
    cargo.args(["clean", "--quiet", "--offline", "--release"]);
    cargo.args(packages.iter().flat_map(|package| ["--package", *package]));
    let finished = run_process(&mut cargo, sandbox.limits.build)?;
    let well = finished.status.is_some_and(|status| status.success());
    ensure!(well, "what was built before cannot be removed: {}", finished.stderr.trim());
    Ok(())
}

/// Empties sources that were compiled. Their times are old, so they are not compiled again.
fn empty(root: &Path, lab: Lab, sources: &Sources) -> Result<()> {
    for path in sources.keys() {
        let file = File::create(root.join(format!("labs/lab{lab}")).join(path))?;
        file.set_modified(SystemTime::UNIX_EPOCH)?;
    }
    Ok(())
}

/// Leaves nothing in a tree of which a submission could make its answers: no tests, no snapshots, no book.
fn strip(root: &Path, lab: Lab) -> Result<()> {
    let tests = root.join("tests");
    let mut folders = vec![root.join("book"), root.join(format!("labs/lab{lab}/tests"))];
    for entry in fs::read_dir(&tests)? {
        folders.push(entry?.path());
    }
    let is_package = |path: &Path| path.join("Cargo.toml").is_file();
    for path in folders.into_iter().filter(|path| !is_package(path)) {
        if path.is_dir() {
            fs::remove_dir_all(path)?;
        } else if path.exists() {
            fs::remove_file(path)?;
        }
    }
    // While a submission's sources are exchanged, the package has this target.
    write_file(&root.join(format!("labs/lab{lab}/tests/none.rs")), "")
}

/// What grading depends on: questions and solution. Not the rubric: marks can be computed again from
/// records.
pub(crate) fn graded_by(kit: &Kit, lab: Lab) -> Result<Sources> {
    let mut sources = of_solution(kit, lab)?;
    for path in programs::files(kit, lab)? {
        let name = path.strip_prefix(kit.root())?.display().to_string();
        sources.insert(name, read_bytes(&path)?);
    }
    Ok(sources)
}

#[cfg(test)]
mod tests {
    use super::{LATE, is_of_a_source};

    #[test]
    fn an_error_with_a_place_is_of_a_source() {
        for (why, own) in [
            ("error[E0425]: `x`\n  --> src/lib.rs:3:5\n", true),
            ("it compiles, but not:\nsrc/bin/answer.rs:3:5: error[E0308]: types\n", true),
            (&format!("{LATE} 120 s"), true),
            ("error: failed to write x: No space left on device (os error 28)", false),
            ("error: linking with `cc` failed\ncollect2: error: ld returned 1 exit status", false),
            ("its build needed more memory than it may have", false),
            ("thread 'rustc' panicked", false),
        ] {
            assert_eq!(is_of_a_source(why), own, "{why}");
        }
    }
}
