//! The checks of one variant of a lab that runs on ranks.

use std::path::{Path, PathBuf};

use common::soft::{Particle, Scene};
use tempfile::TempDir;

use super::job::count;
use super::{Ended, Job, ends_when_a_rank_is_killed};
use crate::Model;
use crate::bits::difference;
use crate::compare::one_step;
use crate::frames::{read_frames, write_scene};
use crate::long_run::{OFFICIAL_SHA256, sha256};

/// Checks one variant of a lab's program, from outside: it is started with `mpiexec`, reads its
/// scene from a file and writes all states with all digits to another.
///
/// Every check panics in the domain's words.
#[derive(Clone)]
pub struct OnRanks {
    task: &'static str,
    program: PathBuf,
    variant: &'static str,
    ranks: usize,
    options: Vec<String>,
    seconds: u64,
}

impl OnRanks {
    /// Variant `variant` of `program` on `ranks` ranks, for task `task`.
    pub fn new(task: &'static str, program: &str, variant: &'static str, ranks: usize) -> Self {
        let program = program.into();
        Self { task, program, variant, ranks, options: Vec::new(), seconds: 30 }
    }

    /// The same with one more option of the program.
    #[must_use]
    pub fn option(mut self, option: &str, value: &str) -> Self {
        self.options.extend([option.into(), value.into()]);
        self
    }

    /// The same with another time limit.
    #[must_use]
    pub fn seconds(mut self, seconds: u64) -> Self {
        self.seconds = seconds;
        self
    }

    /// The job that runs the variant; more arguments may follow.
    pub fn job(&self) -> Job {
        Job::new(self.task, &self.program, self.ranks)
            .args(["--variant", self.variant])
            .args(&self.options)
            .within(self.seconds)
    }

    /// After every one of `steps` steps the bits are those of all pairs in ascending order.
    pub fn bits_of_all_pairs(&self, scene: &Scene, steps: usize) {
        self.same_bits(scene, self.states(scene, steps));
    }

    /// The same on the counter scene of `n` particles, which each rank makes for itself.
    pub fn bits_of_all_pairs_in_a_counter_scene(&self, n: u64, steps: usize) {
        let scene = Scene::counter(n, 1).expect("the scene is sound");
        let job = self.job().args(["--generator", "counter", "-s", "1", "-n", &n.to_string()]);
        self.same_bits(&scene, self.states_of(job, scene.len(), steps));
    }

    /// Every one of `steps` steps is the model's up to rounding, from where it began.
    pub fn follows_the_model(&self, scene: &Scene, steps: usize) {
        let mut before = scene.particles().to_vec();
        for (step, state) in (1..).zip(self.states(scene, steps)) {
            if let Err(mistake) = one_step(scene.size(), &before, &state, None) {
                panic!("{}, step {step}, {mistake}", self.name());
            }
            before = state;
        }
    }

    /// The states after each of `steps` steps, in id order.
    pub fn states(&self, scene: &Scene, steps: usize) -> Vec<Vec<Particle>> {
        let folder = folder();
        let path = written(folder.path(), scene);
        self.states_of(self.job().arg("--scene").arg(path), scene.len(), steps)
    }

    /// The state after `steps` steps, more than one, of a run that looks at the first and the last of them only.
    pub fn last_state(&self, scene: &Scene, steps: usize) -> Vec<Particle> {
        let folder = folder();
        let path = written(folder.path(), scene);
        let job = self.job().arg("--scene").arg(path).args(["--steps", &steps.to_string()]);
        let states = self.frames(job, scene.len(), steps - 1);
        states.into_iter().next_back().expect("the run had steps")
    }

    fn same_bits(&self, scene: &Scene, states: Vec<Vec<Particle>>) {
        let mut model = Model::new(scene);
        let mut before = scene.particles().to_vec();
        for (step, state) in (1..).zip(states) {
            model.step();
            if let Some(words) = difference(&state, &model.particles) {
                // A pair that was missed says more than a digit that is off.
                if let Err(mistake) = one_step(scene.size(), &before, &state, None) {
                    panic!("{}, step {step}, {mistake}", self.name());
                }
                panic!("{}, step {step}: not the bits of all pairs: {words}", self.name());
            }
            before = state;
        }
    }

    /// The official run, n = 1000 and seed 1: byte for byte what the reference program writes.
    pub fn official_bytes(&self) {
        let folder = folder();
        let out = folder.path().join("out.txt");
        self.job().args(["-n", "1000", "-s", "1", "-o"]).arg(&out).succeed();
        let bytes = std::fs::read(&out)
            .unwrap_or_else(|e| panic!("{}: it wrote no output: {e}", self.name()));
        let digest = sha256(&bytes);
        if digest != OFFICIAL_SHA256 {
            panic!(
                "{}: the official output differs from the reference program's (sha256 {digest})",
                self.name()
            );
        }
    }

    /// A rank that is killed in the middle of a run takes the job with it.
    pub fn ends_when_a_rank_is_killed(&self) {
        let folder = folder();
        // Only a program that works has a middle to be killed in.
        self.job().args(["--steps", "3"]).succeed();
        let out = folder.path().join("never-complete.txt");
        // Its ranks have to start, to be killed and to be missed.
        let job = self.job().within(60).args(["--steps", "100000000", "-o"]).arg(&out);
        ends_when_a_rank_is_killed(&self.name(), &job, &out);
    }

    /// Steps `scene` and returns what the program printed.
    pub fn run(&self, scene: &Scene, steps: usize, options: &[&str]) -> Ended {
        let folder = folder();
        let path = written(folder.path(), scene);
        let steps = steps.to_string();
        self.job().arg("--scene").arg(path).args(["--steps", &steps]).args(options).succeed()
    }

    /// The averages that a run with statistics prints, in words; not how many pairs are looked at.
    pub fn averages(&self, scene: &Scene, steps: usize) -> String {
        let printed = self.run(scene, steps, &["--statistics"]).stdout;
        let line = |name| printed.lines().find(|line| line.starts_with(name));
        let both = line("absmin").zip(line("neighbours").and_then(|line| line.split(',').next()));
        let (distances, neighbours) =
            both.unwrap_or_else(|| panic!("{}: no statistics were printed", self.name()));
        format!("{distances}; {neighbours}")
    }

    /// Counters that a run prints, by their names.
    pub fn counters<const N: usize>(
        &self,
        scene: &Scene,
        steps: usize,
        names: [&str; N],
    ) -> [f64; N] {
        let printed = self.run(scene, steps, &[]).stdout;
        names.map(|name| {
            let value =
                printed.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(" = "));
            value.and_then(|value| value.parse().ok()).expect("the counter is printed")
        })
    }

    /// The states of `n` particles after each of `steps` steps of `job`, in id order.
    fn states_of(&self, job: Job, n: usize, steps: usize) -> Vec<Vec<Particle>> {
        self.frames(job.args(["--steps", &steps.to_string()]), n, 1)
    }

    /// The states of `n` particles after the first and every `every` further steps of `job`.
    fn frames(&self, job: Job, n: usize, every: usize) -> Vec<Vec<Particle>> {
        let folder = folder();
        let out = folder.path().join("states.txt");
        job.args(["--every", &every.to_string(), "--full", "-o"]).arg(&out).succeed();
        let unreadable = |e| panic!("{}: its output cannot be read: {e}", self.name());
        read_frames(&out, n).unwrap_or_else(unreadable)
    }

    /// `task 5.8, variant through-root, 3 ranks`: how messages begin.
    pub fn name(&self) -> String {
        format!("task {}, variant {}, {}", self.task, self.variant, count(self.ranks))
    }
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("the temporary folder is writable")
}

fn written(folder: &Path, scene: &Scene) -> PathBuf {
    let path = folder.join("scene.txt");
    write_scene(&path, scene).expect("the temporary folder is writable");
    path
}
