//! One run of one program: its command line, and what it says about itself.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, anyhow, bail};
use oracle::mpiexec::Launcher;
use serde::{Deserialize, Serialize};
use tempfile::TempDir;

use super::scene_file::{spread, write_scene};
use super::variants::{Known, variants};
use lab_kit::program::{Binaries, Program};

/// What is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scene {
    /// The official scene of so many soft discs, seed 1.
    Soft {
        /// Particles.
        n: usize,
    },
    /// The counter scene of so many soft discs, seed 1: a rank makes its share and no more.
    Counter {
        /// Particles.
        n: usize,
    },
    /// The official scene of so many soft discs, seed 1, spread or pressed together.
    Spread {
        /// Particles.
        n: usize,
        /// Particles in the area of a cutoff disc.
        neighbours: f64,
    },
    /// Random hard discs, seed 1.
    Hard {
        /// Discs.
        n: usize,
        /// Side of the box.
        side: f64,
        /// Radius of a disc.
        radius: f64,
        /// How they are drawn, where that is not the assignment's way.
        #[serde(flatten)]
        random: Random,
    },
}

/// How random hard discs differ from the assignment's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Random {
    /// Least and greatest velocity component.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speeds: Option<(f64, f64)>,
    /// Side of the square in the middle that they begin in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blob: Option<f64>,
}

impl Scene {
    /// Soft discs; 100,000 if nobody says how many.
    pub fn soft(n: Option<usize>) -> Self {
        Self::Soft { n: n.unwrap_or(100_000) }
    }

    /// The discs of the CS3210 report's comparisons: 10,000 of radius 1 in a box of side 20,000,
    /// or another number in a box of that side.
    pub fn hard(n: Option<usize>) -> Self {
        let random = Random::default();
        Self::Hard { n: n.unwrap_or(10_000), side: 20_000.0, radius: 1.0, random }
    }

    /// The number of particles or discs.
    pub fn n(&self) -> usize {
        match *self {
            Self::Soft { n }
            | Self::Counter { n }
            | Self::Spread { n, .. }
            | Self::Hard { n, .. } => n,
        }
    }
}

/// A program and what it has to do.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Which program.
    pub program: Program,
    /// On what.
    pub scene: Scene,
    /// For how many time steps.
    pub steps: u64,
    /// With how many threads, or ranks if it has ranks; what the program itself says goes first.
    pub workers: usize,
    /// Whether to collect statistics, which costs time.
    pub statistics: bool,
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
}

/// Averages over the steps of a run.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Statistics {
    /// Pairs looked at per particle and step.
    pub pair_tests: f64,
}

/// What it takes to run jobs: binaries, a launcher of ranks, a folder for inputs.
pub struct Runner {
    binaries: Binaries,
    launcher: Option<Launcher>,
    inputs: TempDir,
}

impl Job {
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

    fn arguments(&self, input: &Path) -> Vec<OsString> {
        let mut arguments: Vec<OsString> = Vec::new();
        let mut add = |words: &[&str]| arguments.extend(words.iter().map(OsString::from));
        match self.scene {
            Scene::Soft { n } | Scene::Counter { n } => {
                add(&["-n", &n.to_string(), "--steps", &self.steps.to_string()]);
            }
            Scene::Spread { .. } => {
                add(&["--scene", &input.to_string_lossy(), "--steps", &self.steps.to_string()]);
            }
            Scene::Hard { random, .. } => {
                add(&[&input.to_string_lossy()]);
                if let Some((least, greatest)) = random.speeds {
                    add(&["--speeds", &format!("{least},{greatest}")]);
                }
                if let Some(side) = random.blob {
                    add(&["--blob", &side.to_string()]);
                }
            }
        }
        if matches!(self.scene, Scene::Counter { .. }) {
            add(&["--generator", "counter"]);
        }
        if !matches!(self.scene, Scene::Spread { .. }) {
            add(&["-s", "1"]);
        }
        add(&["-t", &self.threads().to_string(), "--json"]);
        if let Some(variant) = &self.program.variant {
            add(&["--variant", variant]);
        }
        for (name, value) in &self.program.parameters {
            add(&["--param", &format!("{name}={value}")]);
        }
        if self.statistics {
            add(&["--statistics"]);
        }
        arguments
    }

    /// Writes what the program reads from a file, where the command line does not say all.
    fn write_input(&self, input: &Path) -> Result<()> {
        match self.scene {
            Scene::Soft { .. } | Scene::Counter { .. } => Ok(()),
            Scene::Spread { n, neighbours } => write_scene(input, &spread(n, neighbours)?),
            Scene::Hard { n, side, radius, .. } => {
                fs::write(input, format!("{n} {side} {radius} {} perf\n", self.steps))
                    .with_context(|| format!("cannot write {}", input.display()))
            }
        }
    }
}

impl Runner {
    /// Gets ready to run programs that are built; looks for an MPI only if one needs it.
    pub fn new(binaries: Binaries, programs: &[Program]) -> Result<Self> {
        let launcher = programs.iter().any(Program::has_ranks).then(Launcher::find).transpose()?;
        Ok(Self { binaries, launcher, inputs: tempfile::tempdir()? })
    }

    /// Runs a job to its end.
    pub fn run(&self, job: &Job) -> Result<Outcome> {
        let binary = self.binaries.of(&job.program)?;
        let mut command = match (job.ranks(), &self.launcher) {
            (Some(ranks), Some(launcher)) => launcher.start(ranks, binary),
            _ => Command::new(binary),
        };
        let input = self.inputs.path().join("input.txt");
        job.write_input(&input)?;
        command.args(job.arguments(&input)).stdin(Stdio::null());
        let output = command.output().with_context(|| format!("{} did not start", job.program))?;
        let stdout = String::from_utf8_lossy(&output.stdout);
        if !output.status.success() {
            bail!(
                "{} failed: {}",
                job.program,
                complaint(&String::from_utf8_lossy(&output.stderr))
            );
        }
        let line = stdout.lines().find(|line| line.starts_with('{'));
        let line = line.ok_or_else(|| anyhow!("{} printed no results", job.program))?;
        serde_json::from_str(line).with_context(|| format!("{} printed odd results", job.program))
    }

    /// A lab's variants, and what can be set in each.
    pub fn variants(&self, program: &Program) -> Result<Vec<Known>> {
        variants(&self.binaries, program, self.launcher.as_ref())
    }
}

impl Runner {
    /// What the binary of this name prints.
    ///
    /// # Errors
    /// It does not start, or fails: then in its own words.
    pub fn words_of(&self, binary: &str) -> Result<String> {
        let output = Command::new(self.binaries.named(binary)?).stdin(Stdio::null()).output();
        let output = output.with_context(|| format!("{binary} did not start"))?;
        if !output.status.success() {
            bail!("{}", complaint(&String::from_utf8_lossy(&output.stderr)));
        }
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }
}

/// The line of a failed run that says why: a panic's message, or the last one.
pub fn complaint(stderr: &str) -> &str {
    let lines = || stderr.lines().filter(|line| !line.trim().is_empty());
    let after_panic = lines().skip_while(|line| !line.contains("panicked at")).nth(1);
    let error = lines().find(|line| line.starts_with("error"));
    let line = after_panic.or(error).or(lines().next_back()).unwrap_or("it said nothing");
    line.strip_prefix("error: ").unwrap_or(line).trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn job(program: &str, scene: Scene) -> Job {
        let program = program.parse().unwrap();
        Job { program, scene, steps: 10, workers: 2, statistics: false }
    }

    fn line(job: &Job) -> String {
        let words = job.arguments(Path::new("in"));
        words.iter().map(|w| w.to_string_lossy()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn soft_discs_come_from_the_command_line() {
        let job = job("solution3:fork-join,padding=1", Scene::Soft { n: 500 });
        let words = "-n 500 --steps 10 -s 1 -t 2 --json --variant fork-join --param padding=1";
        assert_eq!(line(&job), words);
        assert_eq!((job.ranks(), job.threads(), job.all_workers()), (None, 2, 2));
    }

    #[test]
    fn a_counter_scene_is_asked_for() {
        let job = job("solution6:halo", Scene::Counter { n: 500 });
        let words = "-n 500 --steps 10 --generator counter -s 1 -t 1 --json --variant halo";
        assert_eq!(line(&job), words);
    }

    #[test]
    fn scenes_that_the_command_line_cannot_say_come_from_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("in");
        let hard = job("lab7:grid,t=4", Scene::hard(Some(100)));
        assert_eq!(line(&hard), "in -s 1 -t 4 --json --variant grid");
        hard.write_input(&input).unwrap();
        assert_eq!(fs::read_to_string(&input).unwrap(), "100 20000 1 10 perf\n");
        let spread = job("solution10:planned", Scene::Spread { n: 400, neighbours: 4.7 });
        assert_eq!(line(&spread), "--scene in --steps 10 -t 2 --json --variant planned");
        spread.write_input(&input).unwrap();
        let file = std::io::BufReader::new(fs::File::open(&input).unwrap());
        assert_eq!(common::soft::read_scene(file).unwrap().len(), 400);
    }

    #[test]
    fn how_hard_discs_are_drawn_is_said_on_the_command_line() {
        let random = Random { speeds: Some((2.0, 5.0)), blob: Some(1000.0) };
        let job = job("lab7:grid", Scene::Hard { n: 100, side: 1e7, radius: 1.0, random });
        let words = "in --speeds 2,5 --blob 1000 -s 1 -t 2 --json --variant grid";
        assert_eq!(line(&job), words);
    }

    #[test]
    fn workers_are_ranks_where_there_are_ranks() {
        let scene = Scene::Soft { n: 500 };
        let plain = job("lab6:halo", scene);
        assert_eq!((plain.ranks(), plain.threads(), plain.all_workers()), (Some(2), 1, 2));
        let hybrid = job("lab6:halo,r=3,t=2", scene);
        assert_eq!((hybrid.ranks(), hybrid.threads(), hybrid.all_workers()), (Some(3), 2, 6));
    }

    #[test]
    fn a_failure_is_told_in_its_own_words() {
        let todo = "\nthread 'main' (1) panicked at labs/lab2/src/grid.rs:5:9:\nnot yet implemented: task 2.1: bins\nnote: run with `RUST_BACKTRACE=1`\n";
        assert_eq!(complaint(todo), "not yet implemented: task 2.1: bins");
        assert_eq!(complaint("error: there is no variant 'x'\n"), "there is no variant 'x'");
        assert_eq!(complaint("a\nb\n"), "b");
        assert_eq!(complaint(""), "it said nothing");
    }
}
