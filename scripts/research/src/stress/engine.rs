//! Who is put under stress: a program, or in a test an engine in this process.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::mpiexec::Launcher;

use super::method::Method;
use lab_kit::process;
use lab_kit::program::{Binaries, Program};
use lab_measure::job::complaint;
use lab_measure::scene_file::write_scene;
use lab_measure::variants::Parameter;

/// A run may take so long.
const LIMIT: Duration = Duration::from_secs(120);

/// What is asked of an engine.
pub(super) struct Asked<'a> {
    pub(super) scene: &'a Scene,
    pub(super) steps: u64,
    /// States wanted: after steps 1, 1 + every, 1 + 2 every, …
    pub(super) every: u64,
    /// The length of a step in official ones.
    pub(super) stretch: f64,
}

/// What came of it.
pub(super) enum Answer {
    /// The states that were asked for.
    Frames(Vec<Vec<Particle>>),
    /// It cannot do this, and says why.
    Unable(&'static str),
    /// It broke down.
    Broke(String),
}

/// Something that moves soft discs.
pub(super) trait Engine {
    /// What tables call it.
    fn name(&self) -> String;

    /// How it says that it goes through time.
    fn method(&self) -> Method;

    /// Runs a scene.
    fn run(&self, asked: &Asked) -> Answer;
}

/// A lab's program.
pub(super) struct Lab<'a> {
    pub(super) program: Program,
    pub(super) parameters: Vec<Parameter>,
    pub(super) binaries: &'a Binaries,
    pub(super) launcher: Option<&'a Launcher>,
    pub(super) folder: &'a Path,
}

impl Lab<'_> {
    /// Its command line up to the variant; a program with ranks starts as many as `ranks`.
    pub(super) fn command(&self, ranks: usize) -> Result<Command> {
        let binary: &PathBuf = self.binaries.of(&self.program)?;
        let mut command = match self.launcher {
            Some(launcher) if self.program.has_ranks() => launcher.start(ranks, binary),
            _ => Command::new(binary),
        };
        if let Some(variant) = &self.program.variant {
            command.args(["--variant", variant]);
        }
        for (name, value) in &self.program.parameters {
            command.args(["--param", &format!("{name}={value}")]);
        }
        Ok(command)
    }

    fn has(&self, parameter: &str) -> bool {
        self.parameters.iter().any(|known| known.name == parameter)
    }

    fn frames(&self, asked: &Asked) -> Result<Answer> {
        let (start, frames) = (self.folder.join("scene.txt"), self.folder.join("frames.txt"));
        write_scene(&start, asked.scene)?;
        let (mut steps, mut every) = (asked.steps, asked.every);
        // Two that wait for each other a million times would measure the machine's load.
        let (ranks, threads) = match (self.program.has_ranks(), steps > 5_000) {
            (_, true) => (1, "1"),
            (true, false) => (2, "1"),
            (false, false) => (1, "2"),
        };
        let mut command = self.command(ranks)?;
        if self.has("stretch") {
            command.args(["--param", &format!("stretch={}", asked.stretch)]);
        } else if self.has("substeps") {
            // Free flight does not know how long a step is. About ten small steps for a long one are
            // fewer for each official one.
            let parts = (10.0 / asked.stretch).floor();
            command.args(["--param", &format!("substeps={parts}")]);
            (steps, every) =
                ((steps as f64 * asked.stretch) as u64, (every as f64 * asked.stretch) as u64);
        } else if asked.stretch != 1.0 {
            return Ok(Answer::Unable("its step is built in"));
        }
        command.args(["-t", threads, "--full", "--json", "--steps", &steps.to_string()]);
        command.args(["--every", &every.to_string(), "--scene"]).arg(&start).arg("-o").arg(&frames);
        let _ = fs::remove_file(&frames);
        let done = process::run(&mut command, LIMIT)?;
        match done.status {
            None => return Ok(Answer::Broke(format!("no answer within {} s", LIMIT.as_secs()))),
            Some(status) if !status.success() => {
                return Ok(Answer::Broke(complaint(&done.stderr).to_owned()));
            }
            Some(_) => {}
        }
        let text = fs::read_to_string(&frames).context("it wrote no frames")?;
        read_frames(&text, asked.scene.len()).map(Answer::Frames)
    }
}

impl Engine for Lab<'_> {
    fn name(&self) -> String {
        self.program.to_string()
    }

    fn method(&self) -> Method {
        Method::of(self.program.variant.as_deref().unwrap_or_default())
    }

    fn run(&self, asked: &Asked) -> Answer {
        self.frames(asked).unwrap_or_else(|e| Answer::Broke(format!("{e:#}")))
    }
}

/// The states of a file of full frames, each of `n` particles.
fn read_frames(text: &str, n: usize) -> Result<Vec<Vec<Particle>>> {
    let lines: Vec<&str> = text.lines().skip(1).filter(|line| !line.is_empty()).collect();
    let particle = |(at, line): (usize, &&str)| {
        let mut numbers = line.split(' ').map(str::parse);
        let mut next = || numbers.next()?.ok();
        let (x, y, vx, vy) = (next()?, next()?, next()?, next()?);
        Some(Particle { x, y, vx, vy, id: (at % n) as u32 })
    };
    let all: Option<Vec<_>> = lines.iter().enumerate().map(particle).collect();
    let all = all.ok_or_else(|| anyhow!("it wrote lines that are no 'x y vx vy'"))?;
    anyhow::ensure!(all.len() % n == 0, "it wrote {} particles, no multiple of {n}", all.len());
    Ok(all.chunks(n).map(<[_]>::to_vec).collect())
}
