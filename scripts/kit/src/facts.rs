//! What a lab is: `lab.toml` in its folder. The tool, the book, the grader, scripts/test.sh and scripts/slurm read
//! it, and nothing in it stands anywhere else.
//!
//! ```toml
//! title = "on a graphics processor"
//! discs = "soft"
//! workers = "device"
//! programs = { hard = "hard" }
//!
//! [tasks."9.1"]
//! title = "launches"
//! points = 14
//! hours = 1.0
//! mark = 2
//! section = "Launches"
//! hints = ["a nudge", "the idea", "nearly the answer"]
//! ```

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The facts of a lab.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Facts {
    /// What it is called, such as `all pairs`.
    pub title: String,
    /// What its program simulates.
    pub discs: Discs,
    /// What shares the work.
    pub workers: Workers,
    /// Work of its other programs, by the part of their names behind the lab's: `hard` for `lab9-hard`.
    #[serde(default)]
    pub programs: BTreeMap<String, Work>,
    /// The variant that is the kit's best serial program for such discs, if it is this lab's: what t₁ is
    /// taken from.
    pub baseline: Option<String>,
    /// The variant that `scripts/slurm` runs on 1, 2, 4, … ranks or threads.
    pub cluster: Option<String>,
    /// The variant with threads in each rank, which `scripts/slurm` runs for each split of a node.
    pub hybrid: Option<String>,
    /// What `cargo lab movie` shows of it at first.
    #[serde(default)]
    pub movie: Movie,
    /// Commands of `cargo lab` that scripts/test.sh runs for a few seconds each.
    #[serde(default)]
    pub smoke: Vec<String>,
    /// What its reader can do afterwards.
    #[serde(default)]
    pub able: Vec<String>,
    /// What to know before.
    #[serde(default)]
    pub before: Vec<String>,
    /// Hours to read, predict, measure and explain.
    #[serde(default)]
    pub reading: f64,
    /// Its tasks, such as `9.2`.
    #[serde(default)]
    pub tasks: BTreeMap<String, TaskFacts>,
    /// What the growth of its time with the number of particles is worth; none if that is not graded.
    pub complexity: Option<Timed>,
    /// What its speed-up by more workers is worth.
    pub scaling: Option<Timed>,
    /// What its time beside the solution's is worth.
    pub speed: Option<Timed>,
    /// The loops that `cargo lab speed` times.
    #[serde(default, rename = "race")]
    pub races: Vec<Race>,
    /// Its variants, as the comparison of all has them.
    #[serde(default, rename = "variant")]
    pub variants: Vec<VariantFacts>,
}

/// The facts of a task.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TaskFacts {
    /// What it is called, such as `launches`.
    #[serde(default)]
    pub title: String,
    /// What it is worth: given if all answers to its questions (tests/labN.rs) are right, and not otherwise.
    pub points: f64,
    /// The share of that which a wrong task can still earn, 0 to 1: in proportion to the questions that were
    /// answered rightly.
    #[serde(default)]
    pub partial: f64,
    /// Hours that it takes.
    pub hours: f64,
    /// Its difficulty: 1, follow the text, to 3, take your time.
    pub mark: usize,
    /// The heading of its section in the lab's chapter.
    pub section: String,
    /// Three hints: a nudge, the idea, nearly the answer.
    #[serde(default)]
    pub hints: Vec<String>,
}

/// Points for the times of one variant. Where they are too noisy they stay open.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Timed {
    /// Points for the full grade, on top of the tasks'.
    pub points: f64,
    /// Which program.
    pub variant: String,
    /// The number of particles, or the greatest one.
    pub n: usize,
}

/// A task's loop beside one that takes as long, if the task is done as the chapter says. Both are the lab's own
/// programs: a student without the solutions can race them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Race {
    /// Whose loop it is.
    pub task: String,
    /// The program that runs the loop, without the lab's name: `alone:drift` for `lab10-alone:drift`.
    pub program: String,
    /// The program beside it.
    pub against: String,
    /// The number of particles.
    pub n: usize,
    /// What to say if the loop is slower, with `{}` for how many times.
    pub slow: String,
    /// What it works on, one for each particle: `pairs`.
    pub of: String,
}

/// What no command knows of a variant.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VariantFacts {
    /// Its name.
    pub name: String,
    /// The last of the tasks that it is made of. Where all up to that one are right, grading runs it as a whole; if it
    /// is wrong all the same, it costs that task.
    pub task: Option<String>,
    /// How its results compare with the naive program's.
    pub error: String,
    /// Whether it works on one thread, whatever the number of workers is.
    #[serde(default)]
    pub serial: bool,
    /// How it shares its work out.
    pub scaling: String,
    /// What it keeps, beside the particles.
    pub memory: String,
    /// When to use it.
    pub when: String,
}

/// What is switched on in a movie of the lab until its reader chooses. The words are those of
/// book/src/live/movie.js.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Movie {
    /// The layers beside speed and touching: bins, asked, list, owners, ghosts, windows.
    pub layers: Vec<String>,
    /// How it finds the pairs to look at: all, bins, list.
    pub asks: String,
    /// What its owners have alike: even, their rows; equal, their numbers of particles; number, no rows.
    pub cut: String,
}

impl Default for Movie {
    fn default() -> Self {
        Self { layers: Vec::new(), asks: "bins".into(), cut: "even".into() }
    }
}

/// What is simulated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Discs {
    /// Particles that repel each other within a cutoff.
    #[default]
    Soft,
    /// Discs that collide.
    Hard,
}

/// Work of another program of a lab.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Work {
    /// It simulates particles that repel each other within a cutoff.
    Soft,
    /// It simulates discs that collide.
    Hard,
    /// It runs single loops, which `cargo lab speed` times.
    Loops,
}

/// What shares the work of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Workers {
    /// Threads of one process, or one thread.
    #[default]
    Threads,
    /// Processes that exchange messages: needs an MPI library.
    Ranks,
    /// A graphics processor: needs a Vulkan driver.
    Device,
}

impl Workers {
    /// What a reader must have installed.
    pub fn need(self) -> &'static str {
        match self {
            Self::Threads => "only Rust",
            Self::Ranks => "an MPI library, which `scripts/setup.sh` installs",
            Self::Device => {
                "a Vulkan driver, or a Mac; `scripts/setup.sh` installs a driver made of software, so no \
                 graphics card is needed"
            }
        }
    }
}

impl Facts {
    /// The name of their file in a lab's folder.
    pub const FILE: &str = "lab.toml";
}
