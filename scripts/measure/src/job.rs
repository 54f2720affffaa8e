//! One run of one program: its command line, and what it says about itself.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use anyhow::{Context, Result, bail};
use common::soft::Particle;
use lab_kit::program::{Binaries, Program};
use lab_kit::{Kit, process};
use oracle::mpiexec::Launcher;
use serde::{Deserialize, Serialize};
use tempfile::TempDir;

use super::scene::{Scene, read_frames};

/// A program and what it has to do.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Job {
    /// Which program.
    pub program: Program,
    /// On what.
    pub scene: Scene,
    /// For how many time steps.
    pub steps: u64,
    /// With how many threads, or ranks if it has ranks; what the program itself says goes first.
    #[serde(skip)]
    pub workers: usize,
    /// Whether to collect statistics, which costs time.
    #[serde(skip)]
    pub statistics: bool,
    /// Whether its states are wanted, after steps 1, 1 + every, 1 + 2 every, …
    #[serde(skip)]
    pub every: Option<u64>,
}

/// What a run says about itself.
#[derive(Clone, Debug, Deserialize)]
pub struct Outcome {
    /// Seconds of stepping, without start, scene and output.
    pub seconds: f64,
    /// Averages over the steps, if they were asked for.
    pub statistics: Option<Statistics>,
    /// What the variant counts.
    #[serde(default)]
    pub counters: BTreeMap<String, f64>,
    /// The states that were asked for.
    #[serde(skip)]
    pub frames: Vec<Vec<Particle>>,
}

/// Averages over the steps of a run.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Statistics {
    /// Pairs looked at per particle and step.
    pub pair_tests: f64,
}

/// A variant that a program has told of.
#[derive(Debug, Deserialize)]
pub struct Known {
    /// Its name.
    pub name: String,
    /// What can be set in it.
    pub parameters: Vec<Parameter>,
}

/// What can be set in a variant.
#[derive(Debug, Deserialize)]
pub struct Parameter {
    /// The name in `--param NAME=VALUE`.
    pub name: String,
}

/// What it takes to run jobs: binaries, a launcher of ranks, a folder for files.
pub struct Runner {
    binaries: Binaries,
    launcher: Option<Launcher>,
    folder: TempDir,
    /// How long a run may take.
    pub limit: Option<Duration>,
}

impl Job {
    /// A step on one worker.
    pub fn new(program: Program, scene: Scene) -> Self {
        Self { program, scene, steps: 1, workers: 1, statistics: false, every: None }
    }

    /// Ranks of the job; none for a program without.
    pub fn ranks(&self) -> Option<usize> {
        self.program.has_ranks().then(|| self.program.ranks.unwrap_or(self.workers))
    }

    /// Threads of the process, or of each rank.
    pub fn threads(&self) -> usize {
        let alone = if self.program.has_ranks() { 1 } else { self.workers };
        self.program.threads.unwrap_or(alone)
    }

    /// All threads of all ranks.
    pub fn all_workers(&self) -> usize {
        self.ranks().unwrap_or(1) * self.threads()
    }

    /// Adds its words to a command that starts the program's variant.
    fn tell(&self, command: &mut Command, folder: &Path) -> Result<()> {
        let file = folder.join("input.txt");
        let (words, with_file) = self.scene.words(&file, self.steps)?;
        command.args(["-t", &self.threads().to_string(), "--json"]);
        command.args(words.split(' ')).args(with_file.then_some(file));
        if self.statistics {
            command.arg("--statistics");
        }
        if let Some(every) = self.every {
            command.args(["--full", "--every", &every.to_string()]);
            command.arg("-o").arg(folder.join(FRAMES));
        }
        Ok(())
    }
}

const FRAMES: &str = "frames.txt";

impl Known {
    /// Whether it has such a parameter.
    pub fn has(&self, parameter: &str) -> bool {
        self.parameters.iter().any(|known| known.name == parameter)
    }
}

impl Runner {
    /// Builds the programs, and looks for an MPI if one needs it.
    ///
    /// # Errors
    /// One does not build, or there is no MPI.
    pub fn build(kit: &Kit, programs: &[Program]) -> Result<Self> {
        let launcher = programs.iter().any(Program::has_ranks).then(Launcher::find).transpose()?;
        let binaries = Binaries::build(kit, programs)?;
        Ok(Self { binaries, launcher, folder: tempfile::tempdir()?, limit: None })
    }

    /// Runs a job to its end.
    ///
    /// # Errors
    /// It does not start, takes too long, fails, or says nothing that can be understood.
    pub fn run(&self, job: &Job) -> Result<Outcome> {
        let name = &job.program;
        let mut command = self.command(name, job.ranks().unwrap_or(1))?;
        job.tell(&mut command, self.folder())?;
        let frames = self.folder().join(FRAMES);
        let _ = std::fs::remove_file(&frames);
        let stdout = self.words(&mut command, &name.to_string())?;
        let line = stdout.lines().find(|line| line.starts_with('{'));
        let line = line.with_context(|| format!("{name} printed no results"))?;
        let mut outcome: Outcome =
            serde_json::from_str(line).with_context(|| format!("{name} printed odd results"))?;
        if job.every.is_some() {
            outcome.frames = read_frames(&frames, job.scene.n())
                .with_context(|| format!("{name} wrote odd frames"))?;
        }
        Ok(outcome)
    }

    /// The beginning of a command that runs a program's variant, on so many ranks if it has ranks.
    pub fn command(&self, program: &Program, ranks: usize) -> Result<Command> {
        let binary = self.binaries.of(program)?;
        let mut command = match &self.launcher {
            Some(launcher) if program.has_ranks() => launcher.start(ranks, binary),
            _ => Command::new(binary),
        };
        if let Some(variant) = &program.variant {
            command.args(["--variant", variant]);
        }
        for (name, value) in &program.parameters {
            command.args(["--param", &format!("{name}={value}")]);
        }
        Ok(command)
    }

    /// A program's variants, or the one that it names, by its answer to `--list-variants --json`.
    ///
    /// # Errors
    /// It does not start, does not answer, or has no such variant.
    pub fn variants(&self, program: &Program) -> Result<Vec<(Program, Known)>> {
        let mut plain = program.clone();
        (plain.variant, plain.parameters) = (None, Vec::new());
        let mut command = self.command(&plain, 1)?;
        let output = command.args(["--list-variants", "--json"]).stdin(Stdio::null()).output();
        let output = output.with_context(|| format!("{} did not start", program.binary()))?;
        let mut known: Vec<Known> = serde_json::from_slice(&output.stdout)
            .with_context(|| format!("{} lists no variants", program.binary()))?;
        if let Some(name) = &program.variant {
            known.retain(|variant| variant.name == *name);
            let package = program.package();
            anyhow::ensure!(!known.is_empty(), "there is no variant '{name}' in {package}");
        }
        let named = |known: Known| (program.clone().with_variant(&known.name), known);
        Ok(known.into_iter().map(named).collect())
    }

    /// What the binary of this name prints.
    ///
    /// # Errors
    /// It does not start, or fails: then in its own words.
    pub fn words_of(&self, binary: &str) -> Result<String> {
        self.words(&mut Command::new(self.binaries.named(binary)?), binary)
    }

    /// Where its files lie.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Runs a command to its end and returns what it prints.
    ///
    /// # Errors
    /// It does not start, takes too long, or fails: then in its own words.
    pub fn words(&self, command: &mut Command, name: &str) -> Result<String> {
        let started = || format!("{name} did not start");
        let (status, stdout, stderr) = match self.limit {
            Some(limit) => {
                let done = process::run(command, limit).with_context(started)?;
                (done.status, done.stdout, done.stderr)
            }
            None => {
                let done = command.stdin(Stdio::null()).output().with_context(started)?;
                let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
                (Some(done.status), text(&done.stdout), text(&done.stderr))
            }
        };
        match status {
            Some(status) if status.success() => Ok(stdout),
            Some(_) => bail!("{name} failed: {}", complaint(&stderr)),
            None => bail!("no answer within {} s", self.limit.unwrap_or_default().as_secs()),
        }
    }
}

/// The line of a failed run that says why: a panic's message, or the last one.
fn complaint(stderr: &str) -> &str {
    let lines = || stderr.lines().filter(|line| !line.trim().is_empty());
    let after_panic = lines().skip_while(|line| !line.contains("panicked at")).nth(1);
    let error = lines().find(|line| line.starts_with("error"));
    let line = after_panic.or(error).or(lines().next_back()).unwrap_or("it said nothing");
    line.strip_prefix("error: ").unwrap_or(line).trim()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::Arc;

    use super::super::scene::Random;
    use super::*;

    fn job(program: &str, scene: Scene) -> Job {
        Job { steps: 10, workers: 2, ..Job::new(program.parse().unwrap(), scene) }
    }

    #[test]
    fn a_job_is_told_on_the_command_line_and_in_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("input.txt");
        let words = |scene| {
            let mut command = Command::new("lab");
            job("lab3", scene).tell(&mut command, folder.path()).unwrap();
            let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy()).collect();
            words.join(" ").replace(&*input.to_string_lossy(), "FILE")
        };
        assert_eq!(words(Scene::Soft { n: 500 }), "-t 2 --json --steps 10 -s 1 -n 500");
        assert!(words(Scene::Counter { n: 500 }).ends_with("-n 500 --generator counter"));
        assert_eq!(words(Scene::usual(Some(100), true)), "-t 2 --json -s 1 FILE");
        assert_eq!(fs::read_to_string(&input).unwrap(), "100 20000 1 10 perf\n");
        let random = Random { speeds: Some((2.0, 5.0)), blob: Some(1000.0) };
        let hard = words(Scene::Hard { n: 100, side: 1e7, radius: 1.0, random });
        assert!(hard.ends_with("-s 1 --speeds 2,5 --blob 1000 FILE"), "{hard}");
        let scene = common::soft::Scene::official(7, 1).unwrap();
        for scene in [Scene::Spread { n: 7, neighbours: 4.7 }, Scene::Given(Arc::new(scene))] {
            assert_eq!(words(scene), "-t 2 --json --steps 10 --scene FILE");
            let file = std::io::BufReader::new(fs::File::open(&input).unwrap());
            assert_eq!(common::soft::read_scene(file).unwrap().len(), 7);
        }
    }

    #[test]
    fn workers_are_ranks_where_there_are_ranks() {
        for (program, expected) in [
            ("solution3:fork-join", (None, 2, 2)),
            ("lab6:halo", (Some(2), 1, 2)),
            ("lab6:halo,r=3,t=2", (Some(3), 2, 6)),
        ] {
            let job = job(program, Scene::Soft { n: 500 });
            assert_eq!((job.ranks(), job.threads(), job.all_workers()), expected, "{program}");
        }
    }

    #[test]
    fn a_failure_is_told_in_its_own_words() {
        let todo = "\nthread 'main' (1) panicked at labs/lab2/src/grid.rs:5:9:\nnot yet implemented: task 2.1: bins\nnote: run with `RUST_BACKTRACE=1`\n";
        for (said, why) in [
            (todo, "not yet implemented: task 2.1: bins"),
            ("error: there is no variant 'x'\n", "there is no variant 'x'"),
            ("a\nb\n", "b"),
            ("", "it said nothing"),
        ] {
            assert_eq!(complaint(said), why);
        }
    }
}
