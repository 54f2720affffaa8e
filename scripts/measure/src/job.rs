//! Jobs: a run of a program, its command line, and the numbers that it prints.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use anyhow::Result;
use common::Event;
use common::soft::Particle;
use lab_kit::program::Program;
use serde::{Deserialize, Deserializer, Serialize};

use super::scene::Scene;

/// Name of the file that a program writes its states to.
pub(crate) const FRAMES: &str = "frames.txt";

/// Name of the file that a program writes its events to.
pub(crate) const EVENTS: &str = "events.txt";

/// A program, its scene, and the settings of its run.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Job {
    /// The program.
    pub program: Program,
    /// The scene that it simulates.
    pub scene: Scene,
    /// Number of time steps.
    pub steps: u64,
    /// Number of threads, or of ranks if the program has ranks. A number in the program's name
    /// takes precedence.
    #[serde(skip)]
    pub workers: usize,
    /// Whether the program collects statistics, which costs time.
    #[serde(skip)]
    pub statistics: bool,
    /// States that the program writes; `None` for no states.
    #[serde(skip)]
    pub states: Option<States>,
    /// Whether the program records the activities of each rank.
    #[serde(skip)]
    pub events: bool,
}

/// The states that a program writes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum States {
    /// The state after step 1, and then a state after each of this number of steps.
    Every(u64),
    /// The state after the last step.
    Last,
}

/// The numbers that a run prints or writes.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct RunOutput {
    /// Seconds that the steps take, without start, scene and output.
    pub seconds: f64,
    /// Seconds of the engine's `load`.
    #[serde(default)]
    pub loading: f64,
    /// Seconds of the engine's `read`.
    #[serde(default)]
    pub reading: f64,
    /// Bytes of memory at the end; `None` if the system does not report them.
    #[serde(default)]
    pub resident: Option<u64>,
    /// Averages over the steps, if the job collects statistics.
    pub statistics: Option<Averages>,
    /// The variant's counters that are finite.
    #[serde(default, deserialize_with = "numbers")]
    pub counters: BTreeMap<String, f64>,
    /// The states, if the job has any.
    #[serde(skip)]
    pub frames: Vec<Vec<Particle>>,
    /// The events, if the job records them.
    #[serde(skip)]
    pub events: Vec<Event>,
}

/// Averages over the steps of a run.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Averages {
    /// Number of pair tests per particle and step.
    pub pair_tests: f64,
    /// Number of neighbours within the cutoff per particle and step; a pair counts for both
    /// particles.
    pub neighbours: f64,
}

impl Job {
    /// Makes a job of one step on one worker.
    pub fn new(program: Program, scene: Scene) -> Self {
        Self {
            program,
            scene,
            steps: 1,
            workers: 1,
            statistics: false,
            states: None,
            events: false,
        }
    }

    /// Returns the number of ranks; `None` for a program without ranks.
    pub fn ranks(&self) -> Option<usize> {
        self.program.has_ranks().then(|| self.program.ranks.unwrap_or(self.workers))
    }

    /// Returns the number of threads of the process, or of each rank.
    pub fn threads(&self) -> usize {
        let alone = if self.program.has_ranks() { 1 } else { self.workers };
        self.program.threads.unwrap_or(alone)
    }

    /// Returns the number of threads of all ranks together.
    pub fn all_workers(&self) -> usize {
        self.ranks().unwrap_or(1) * self.threads()
    }

    /// Returns the job's name in a progress bar.
    pub(crate) fn name(&self) -> String {
        format!("{} n={}", self.program, self.scene.n())
    }

    /// Whether the job has the same program and number of workers; its scene and its parameters may
    /// differ.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        self.program.binary() == other.program.binary()
            && self.program.variant == other.program.variant
            && self.all_workers() == other.all_workers()
    }

    /// Whether the two jobs differ at most in their numbers of steps.
    pub(crate) fn is_but_for_steps(&self, other: &Self) -> bool {
        Self { steps: other.steps, ..self.clone() } == *other
    }

    /// Appends the job's options to a command that starts the program's variant. The program's
    /// files are in `folder`.
    pub(crate) fn tell(&self, command: &mut Command, folder: &Path) -> Result<()> {
        command.args(["-t", &self.threads().to_string(), "--json"]);
        self.scene.tell(command, &folder.join("input.txt"), self.steps)?;
        if self.statistics {
            command.arg("--statistics");
        }
        if let Some(states) = self.states {
            command.arg("--full").arg("-o").arg(folder.join(FRAMES));
            match states {
                States::Every(steps) => command.args(["--every", &steps.to_string()]),
                States::Last => command.arg("--last"),
            };
        }
        if self.events {
            command.arg("--events").arg(folder.join(EVENTS));
        }
        Ok(())
    }
}

/// Reads counters, but omits null, which JSON contains in place of infinite numbers and NaN.
fn numbers<'de, D: Deserializer<'de>>(
    counters: D,
) -> std::result::Result<BTreeMap<String, f64>, D::Error> {
    let all = BTreeMap::<String, Option<f64>>::deserialize(counters)?;
    Ok(all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect())
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::Arc;

    use super::*;

    fn job(program: &str, scene: Scene) -> Job {
        Job { steps: 10, workers: 2, ..Job::new(program.parse().unwrap(), scene) }
    }

    /// Returns the command line of a job; FILE is its scene file in `folder`.
    fn words(folder: &Path, scene: Scene) -> String {
        let mut command = Command::new("lab");
        job("lab3", scene).tell(&mut command, folder).unwrap();
        let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy()).collect();
        words.join(" ").replace(&*folder.join("input.txt").to_string_lossy(), "FILE")
    }

    #[test]
    fn a_job_is_told_on_the_command_line_and_in_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let input = folder.join("input.txt");
        assert_eq!(words(folder, Scene::Soft { n: 500 }), "-t 2 --json --steps 10 -s 1 -n 500");
        assert!(words(folder, Scene::Counter { n: 500 }).ends_with("-n 500 --generator counter"));
        assert_eq!(words(folder, Scene::usual(Some(100), true)), "-t 2 --json -s 1 FILE");
        assert_eq!(fs::read_to_string(&input).unwrap(), "100 20000 1 10 perf\n");
        let speeds = Some((2.0, 5.0));
        let blob = Some(1000.0);
        let hard = words(folder, Scene::Hard { n: 100, side: 1e7, radius: 1.0, speeds, blob });
        assert!(hard.ends_with("-s 1 --speeds 2,5 --blob 1000 FILE"), "{hard}");
        let scene = common::soft::Scene::official(7, 1).unwrap();
        for scene in [Scene::Spread { n: 7, neighbours: 4.7 }, Scene::Given(Arc::new(scene))] {
            assert_eq!(words(folder, scene), "-t 2 --json --steps 10 --scene FILE");
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
}
