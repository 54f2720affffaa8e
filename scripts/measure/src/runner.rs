//! Runs the labs' programs.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};
use lab_kit::binaries::{Binaries, Known};
use lab_kit::program::Program;
use lab_kit::starter::Record;
use lab_kit::{Kit, process};
use oracle::read_frames;
use tempfile::TempDir;

use super::job::{EVENTS, FRAMES, Job, RunOutput};

/// The binaries of programs, and a folder for their files.
pub struct Runner {
    binaries: Binaries,
    folder: TempDir,
    /// Longest time of a run; a month unless a command changes it.
    pub limit: Duration,
}

impl Runner {
    /// Builds the programs, and looks for MPI if a program needs it.
    ///
    /// # Errors
    /// A program is not written yet or does not build, or MPI is not installed.
    pub fn build(kit: &Kit, programs: &[Program]) -> Result<Self> {
        programs.iter().try_for_each(|program| expect_begun(kit, program))?;
        let binaries = Binaries::build(kit, programs)?;
        process::kill_all_on_interrupt();
        let limit = Duration::from_secs(30 * 24 * 3600);
        Ok(Self { binaries, folder: tempfile::tempdir()?, limit })
    }

    /// Runs the programs with a tool from now on; `tool` precedes their command lines.
    pub fn under(&mut self, tool: Vec<String>) {
        self.binaries.tool = tool;
    }

    /// Runs a job to its end.
    ///
    /// # Errors
    /// The program does not start, takes too long, fails, or prints no results.
    pub fn run(&self, job: &Job) -> Result<RunOutput> {
        let name = &job.program;
        let mut command = self.command(name, job.ranks().unwrap_or(1))?;
        job.tell(&mut command, self.folder())?;
        let frames = self.folder().join(FRAMES);
        let _ = fs::remove_file(&frames);
        let stdout = self.words(&mut command, &name.to_string())?;
        let line = stdout.lines().find(|line| line.starts_with('{'));
        let line = line.with_context(|| format!("{name} printed no results"))?;
        let mut output: RunOutput =
            serde_json::from_str(line).with_context(|| format!("{name} printed odd results"))?;
        if job.states.is_some() {
            output.frames = read_frames(&frames, job.scene.n())
                .with_context(|| format!("{name} wrote odd frames"))?;
        }
        if job.events {
            let lines = fs::read_to_string(self.folder().join(EVENTS))
                .with_context(|| format!("{name} wrote no events"))?;
            output.events = lines.lines().map(str::parse).collect::<Result<_, _>>()?;
        }
        Ok(output)
    }

    /// Returns a command that runs a program's variant, on `ranks` ranks if the program has ranks.
    ///
    /// # Errors
    /// The program was not built.
    pub fn command(&self, program: &Program, ranks: usize) -> Result<Command> {
        let mut command = self.binaries.start(program, ranks)?;
        if let Some(variant) = &program.variant {
            command.args(["--variant", variant]);
        }
        for (name, value) in &program.parameters {
            command.args(["--param", &format!("{name}={value}")]);
        }
        Ok(command)
    }

    /// Returns the variants of all programs, or the one that a program names.
    pub(crate) fn variants(&self, programs: &[Program]) -> Result<Vec<(Program, Known)>> {
        let mut all = Vec::new();
        for program in programs {
            all.extend(self.binaries.variants(program)?);
        }
        Ok(all)
    }

    /// Returns the folder of the programs' files.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Runs a command to its end and returns its output.
    ///
    /// # Errors
    /// The command does not start, takes too long, or fails. If it fails, the error is the
    /// command's own message.
    pub fn words(&self, command: &mut Command, name: &str) -> Result<String> {
        let done = process::run(command, self.limit);
        let done = done.with_context(|| format!("{name} did not start"))?;
        match done.status {
            Some(status) if status.success() => Ok(done.stdout),
            Some(_) => bail!("{name} failed: {}", complaint(&done.stderr)),
            None => bail!("no answer within {} s", self.limit.as_secs()),
        }
    }
}

/// Refuses a lab that the student has not begun. The lab would compile for minutes and then panic
/// at its first `todo!`.
fn expect_begun(kit: &Kit, program: &Program) -> Result<()> {
    if program.solution {
        return Ok(());
    }
    let folder = kit.starter(program.lab);
    let record = Record::read(&folder)?;
    let source: Vec<&Path> = record.paths().filter(|path| path.starts_with("src")).collect();
    // The starter of an open lab has no `todo!`, and is a complete program.
    let has_todo = |path: &&Path| {
        fs::read_to_string(folder.join(path)).is_ok_and(|text| text.contains("todo!("))
    };
    let is_given =
        source.iter().any(has_todo) && source.iter().all(|path| record.is_own(&folder, path));
    let mut solved = program.clone();
    solved.solution = true;
    ensure!(
        !is_given,
        "{program} is not written yet: labs/lab{} is as it was given; the kit's program is {solved}",
        program.lab
    );
    Ok(())
}

/// Finds the line that explains a failed run: a panic's message, the last error, or the last line.
///
/// The last error is chosen, because a library may print a different error before it.
fn complaint(stderr: &str) -> &str {
    let lines: Vec<&str> = stderr.lines().filter(|line| !line.trim().is_empty()).collect();
    let error = lines.iter().rfind(|line| line.starts_with("error"));
    let line = error.or(lines.last()).copied();
    let line = process::panic_in(stderr).or(line).unwrap_or("it printed nothing");
    line.strip_prefix("error: ").unwrap_or(line).trim()
}

#[cfg(test)]
mod tests {
    use super::{complaint, expect_begun};
    use lab_kit::Kit;
    use lab_kit::files::digest;
    use lab_kit::program::Program;

    #[test]
    fn a_lab_as_it_was_given_is_not_built() {
        let folder = tempfile::tempdir().unwrap();
        let refused = |source: &str, program: &str| {
            let record = format!("{}  src/a.rs\n", digest(b"todo!()"));
            let files = [("labs/lab2/.starter", &*record), ("labs/lab2/src/a.rs", source)];
            let kit = Kit::of_files(folder.path(), &files);
            let program: Program = program.parse().unwrap();
            expect_begun(&kit, &program).err().map(|e| e.to_string())
        };
        let why = refused("todo!()", "lab2:sorted").unwrap();
        assert!(why.ends_with("the kit's program is solution2:sorted"), "{why}");
        assert_eq!(refused("fn mine() {}", "lab2:sorted"), None);
        assert_eq!(refused("todo!()", "solution2:sorted"), None);
    }

    #[test]
    fn a_failure_is_told_in_its_own_words() {
        let todo = "\nthread 'main' (1) panicked at labs/lab2/src/grid.rs:5:9:\nnot yet implemented: task 2.1: bins\nnote: run with `RUST_BACKTRACE=1`\n";
        for (message, why) in [
            (todo, "not yet implemented: task 2.1: bins"),
            ("error: there is no variant 'x'\n", "there is no variant 'x'"),
            ("error: a driver's\nerror: the program's\nx\n", "the program's"),
            ("a\nb\n", "b"),
            ("", "it printed nothing"),
        ] {
            assert_eq!(complaint(message), why);
        }
    }
}
