//! Builds submissions in a tree: a handout of the lab, with the programs that call the submission.

#[cfg(test)]
mod answers;
mod cache;
mod compile;
mod programs;

use std::fs::{self, File, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use anyhow::{Context, Error, Result, bail};
use tempfile::TempDir;

use crate::asking;
use crate::sandbox::faults::{believed, machine_works, named};
use crate::sandbox::{BUILD_QUOTA, GIVEN_FILE, Sandbox};
use compile::{Order, clean, compile, is_late, is_of_a_source};
use lab_keep::handout;
use lab_kit::files::{read_bytes, write_file};
use lab_kit::rubric;
use lab_kit::sources::{Sources, of_solution};
use lab_kit::{Kit, Lab, files_below};
use programs::{NAMES, Programs};

/// Time limit for building the solution, whose dependencies are compiled too.
const FIRST: Duration = Duration::from_secs(900);

/// Name of the package whose programs call a submission.
const PROBE: &str = "probe";
/// Folder of this package in a tree.
const PACKAGE: &str = "labs/lab-probe";

/// A tree for building submissions, one after another.
pub(crate) struct Tree {
    folder: TempDir,
    lab: Lab,
    programs: Programs,
    /// Sources of the solution. They can be built unless the machine has a fault.
    solution: Sources,
}

/// Folder of the built programs or, if the build failed, the compiler's errors or the message about
/// the time limit.
type Built = std::result::Result<TempDir, String>;

impl Tree {
    /// Makes a tree, without any solution of `lab` or of a later lab.
    pub(crate) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        handout::lay(kit, lab, folder.path(), handout::Earlier::Solutions)?;
        strip(folder.path(), lab)?;
        let own = folder.path().join(format!("labs/lab{lab}"));
        let programs = Programs::of(kit, lab, &rubric::read(kit, lab)?, &own)?;
        programs.hide(&folder.path().join(PACKAGE))?;
        fetch(folder.path());
        cache::put_into(&cache::of(kit), folder.path())?;
        Ok(Self { folder, lab, programs, solution: of_solution(kit, lab)? })
    }

    /// Copies the tree with its compiled files.
    pub(crate) fn copy(&self, sandbox: &Sandbox) -> Result<Self> {
        let folder = sandbox.folder()?;
        cache::copy(self.folder.path(), folder.path()).context("cannot copy a tree for builds")?;
        let programs = self.programs.clone();
        let solution = self.solution.clone();
        Ok(Self { folder, lab: self.lab, programs, solution })
    }

    /// Builds all programs of a submission, as [`Tree::build_some`] does.
    pub(crate) fn build(&self, sandbox: &Sandbox, sources: &Sources) -> Result<Built> {
        self.build_some(sandbox, sources, &NAMES)
    }

    /// Builds those programs of a submission that have these names.
    ///
    /// Only the compiler runs. A submission has no manifest, so it has no build script and no
    /// procedural macro.
    ///
    /// # Errors
    /// If the submission cannot be built, and the solution cannot be built at this moment either.
    /// Then the submission is not the cause.
    pub(crate) fn build_some(
        &self,
        sandbox: &Sandbox,
        sources: &Sources,
        names: &[&str],
    ) -> Result<Built> {
        let order = Order::of_submission(sandbox, sources, names);
        let built = believed(
            || self.build_once(sandbox, &order),
            |built| built.as_ref().is_err_and(|why| !is_of_a_source(why)),
            || self.build_solution(sandbox),
        )?;
        if built.as_ref().is_err_and(|why| is_late(why)) {
            // The machine may be too busy to build anything.
            machine_works(|| self.build_solution(sandbox))?;
        }
        Ok(built)
    }

    /// Builds the solution in place of a submission.
    fn build_solution(&self, sandbox: &Sandbox) -> Result<()> {
        match self.build_once(sandbox, &Order::of_submission(sandbox, &self.solution, &NAMES))? {
            Ok(_) => Ok(()),
            Err(why) => bail!("the solution cannot be built either: {}", named(&why)),
        }
    }

    /// Builds in two passes, so that the submission and the grader's programs cannot read each
    /// other's sources.
    ///
    /// ```text
    ///          submission in the tree    grader's programs in the tree    result
    /// pass 1   sources                   empty programs                   library
    /// pass 2   library, empty sources    sources                          programs
    /// ```
    ///
    /// Therefore a submission cannot include the questions, and the grader's programs cannot
    /// include the submission.
    fn build_once(&self, sandbox: &Sandbox, order: &Order<'_>) -> Result<Built> {
        let root = self.folder.path();
        let until = Instant::now() + order.limit;
        let Order { sources, names, .. } = *order;
        self.programs.hide(&root.join(PACKAGE))?;
        put(root, self.lab, sources, sandbox)?;
        if let Some(why) = compile(root, sandbox, order, until, "human")? {
            return Ok(Err(why));
        }
        empty(root, self.lab, sources)?;
        self.programs.show(&root.join(PACKAGE))?;
        clean(root, &[PROBE], sandbox)?;
        // Short messages do not quote the questions, which a student must not read.
        if let Some(why) = compile(root, sandbox, order, until, "short")? {
            let what =
                "it compiles alone, but the grader cannot call it (was a signature changed?)";
            return Ok(Err(format!("{what}:\n{why}")));
        }
        let folder = sandbox.folder()?;
        for name in names {
            fs::copy(root.join("target/release").join(name), folder.path().join(name))
                .with_context(|| format!("the build made no {name}"))?;
        }
        Ok(Ok(folder))
    }

    /// Returns the disk space of the tree, plus the space that another build adds, in bytes.
    pub(crate) fn room(&self) -> Result<u64> {
        let mut bytes = BUILD_QUOTA;
        for path in files_below(self.folder.path())? {
            bytes += 512 * fs::symlink_metadata(path)?.blocks();
        }
        Ok(bytes)
    }

    /// Builds the solution's programs and the judging program.
    ///
    /// Their compiled dependencies are kept for the next grading run.
    pub(crate) fn reference(&self, kit: &Kit, sandbox: &Sandbox) -> Result<TempDir> {
        let names = &[&NAMES[..], &[asking::JUDGE]].concat();
        let order = Order { sources: &self.solution, names, limit: FIRST, most: GIVEN_FILE };
        let built = self.build_once(sandbox, &order).and_then(|built| built.map_err(Error::msg));
        let built =
            built.with_context(|| format!("the solution of lab {} cannot be built", self.lab))?;
        // The judge contains right answers, so no submission may read it.
        fs::set_permissions(built.path().join(asking::JUDGE), Permissions::from_mode(0o700))?;
        // Nothing of the solution remains in the tree.
        put(self.folder.path(), self.lab, &Sources::new(), sandbox)?;
        cache::keep(&cache::of(kit), self.folder.path())?;
        // The oracle is compiled now. Its sources are emptied, so that no submission can include
        // them.
        for path in files_below(&self.folder.path().join("tests"))? {
            if path.extension().is_some_and(|extension| extension == "rs") {
                File::create(&path)?.set_modified(SystemTime::UNIX_EPOCH)?;
            }
        }
        Ok(built)
    }
}

/// Downloads missing dependencies of a new tree, because a build in the sandbox has no network.
///
/// Listing the dependencies downloads them. If the download fails, the build reports the missing
/// package.
fn fetch(root: &Path) {
    let _ = Kit::at(root).cargo().args(["tree", "--package", PROBE]).output();
}

/// Replaces the previous submission's sources and removes everything that was built from them.
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

/// Empties source files that were compiled. Their modification times are old, so Cargo does not
/// compile them again.
fn empty(root: &Path, lab: Lab, sources: &Sources) -> Result<()> {
    for path in sources.keys() {
        let file = File::create(root.join(format!("labs/lab{lab}")).join(path))?;
        file.set_modified(SystemTime::UNIX_EPOCH)?;
    }
    Ok(())
}

/// Removes everything from a tree that contains answers: tests, snapshots and the book.
fn strip(root: &Path, lab: Lab) -> Result<()> {
    let tests = root.join("tests");
    let mut folders = vec![root.join("book"), root.join(format!("labs/lab{lab}/tests"))];
    for entry in fs::read_dir(&tests)? {
        folders.push(entry?.path());
    }
    // The packages of the tests remain.
    for path in folders.into_iter().filter(|path| !path.join("Cargo.toml").is_file()) {
        if path.is_dir() {
            fs::remove_dir_all(path)?;
        } else if path.exists() {
            fs::remove_file(path)?;
        }
    }
    // While a submission's sources are replaced, the package has only this target.
    write_file(&root.join(format!("labs/lab{lab}/tests/none.rs")), "")
}

/// Returns the files that a grade depends on: the questions and the solution.
///
/// The rubric is not among them, because marks can be recomputed from records.
pub(crate) fn graded_by(kit: &Kit, lab: Lab) -> Result<Sources> {
    let mut sources = of_solution(kit, lab)?;
    for path in programs::files(kit, lab)? {
        let name = path.strip_prefix(kit.root())?.display().to_string();
        sources.insert(name, read_bytes(&path)?);
    }
    Ok(sources)
}
