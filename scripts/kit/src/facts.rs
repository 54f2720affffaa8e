//! Facts about a lab: `lab.toml` in its folder.
//!
//! The tool, the book, the grader, scripts/test.sh and scripts/slurm read this file. No other file
//! repeats its contents.
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
    /// Title, such as `all pairs`.
    pub title: String,
    /// Kind of discs that the lab's program simulates.
    pub discs: Discs,
    /// Workers that share the work of the lab's program.
    pub workers: Workers,
    /// Kinds of the lab's other programs, by the suffix of the name: `hard` for `lab9-hard`.
    #[serde(default)]
    pub programs: BTreeMap<String, Work>,
    /// Variant that determines the serial time t₁: the kit's best serial program for discs of this
    /// kind. `None` if a different lab has this program.
    pub baseline: Option<String>,
    /// Variant that `scripts/slurm` runs on 1, 2, 4, … ranks or threads.
    pub cluster: Option<String>,
    /// Variant with threads in each rank. `scripts/slurm` runs it for each way to divide a node's
    /// cores into ranks and threads.
    pub hybrid: Option<String>,
    /// Initial settings of `cargo lab movie`.
    #[serde(default)]
    pub movie: Movie,
    /// Commands of `cargo lab` that scripts/test.sh runs for a few seconds each.
    #[serde(default)]
    pub smoke: Vec<String>,
    /// Learning outcomes.
    #[serde(default)]
    pub able: Vec<String>,
    /// Prerequisites.
    #[serde(default)]
    pub before: Vec<String>,
    /// Hours for reading, predicting, measuring and explaining.
    #[serde(default)]
    pub reading: f64,
    /// Facts of the lab's tasks, by number, such as `9.2`.
    #[serde(default)]
    pub tasks: BTreeMap<String, TaskFacts>,
    /// Points for the growth of the time with the number of particles; `None` if it is not graded.
    pub complexity: Option<Timed>,
    /// Points for the speed-up with more workers; `None` if it is not graded.
    pub scaling: Option<Timed>,
    /// Points for the time relative to the solution's; `None` if it is not graded.
    pub speed: Option<Timed>,
    /// Points for an entry in the contest, in addition to the tasks' points.
    #[serde(default, rename = "goal")]
    pub goals: Vec<Goal>,
    /// Text about work that is not graded, with advice for the instructor; `None` if all work is
    /// graded.
    pub ungraded: Option<String>,
    /// Loops that `cargo lab speed` times.
    #[serde(default, rename = "race")]
    pub races: Vec<Race>,
    /// Facts about the lab's variants, for the book's tables that compare all variants.
    #[serde(default, rename = "variant")]
    pub variants: Vec<VariantFacts>,
}

/// The facts of a task.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TaskFacts {
    /// Title, such as `launches`.
    #[serde(default)]
    pub title: String,
    /// Points for the task. A submission earns them if all answers to the task's questions
    /// (tests/labN.rs) are right.
    pub points: f64,
    /// Largest share of the points, 0 to 1, that a wrong task can earn. The share is proportional
    /// to the right answers.
    #[serde(default)]
    pub partial: f64,
    /// Hours that the task takes.
    pub hours: f64,
    /// Difficulty: 1 (follow the text) to 3 (take your time).
    pub mark: usize,
    /// Whether the task is optional. Core tasks are not optional: everybody does them.
    #[serde(default)]
    pub optional: bool,
    /// Heading of the task's section in the lab's chapter.
    pub section: String,
    /// Three hints: a nudge, the idea, nearly the answer.
    #[serde(default)]
    pub hints: Vec<String>,
}

/// Points for the times of one variant. They stay open if the times are too noisy.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Timed {
    /// Points for the full grade, in addition to the tasks' points.
    pub points: f64,
    /// Name of the variant.
    pub variant: String,
    /// Number of particles, or the largest number.
    pub n: usize,
}

/// Points for an entry that is better than an engine of the kit in one of the contest's rankings.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Goal {
    /// Program of the engine, which is one of the contest's landmarks.
    pub beats: String,
    /// Points, which are added to the points of other goals.
    pub points: f64,
}

/// A task's loop and a reference loop. Both are equally fast if the task is done as the chapter
/// says.
///
/// Both are programs of the lab, so a student can race them without the solutions.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Race {
    /// Task that the loop belongs to.
    pub task: String,
    /// Program that runs the loop, without the lab's name: `alone:drift` for `lab10-alone:drift`.
    pub program: String,
    /// Program with the reference loop.
    pub against: String,
    /// Number of particles.
    pub n: usize,
    /// Message if the loop is slower, with `{}` for the ratio of the times.
    pub slow: String,
    /// Items that the loop works on, such as `pairs`.
    pub of: String,
}

/// Facts about a variant that no command can measure.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VariantFacts {
    /// Name of the variant.
    pub name: String,
    /// Last task that the variant needs.
    ///
    /// If all tasks up to this one are right, grading runs the whole variant. If its result is
    /// wrong nevertheless, this task loses its points.
    pub task: Option<String>,
    /// Accuracy of the variant's results, compared with the naive program's.
    pub error: String,
    /// Whether the variant uses only one thread, whatever the number of workers.
    #[serde(default)]
    pub serial: bool,
    /// Distribution of the variant's work among the workers.
    pub scaling: String,
    /// Memory that the variant needs in addition to the particles.
    pub memory: String,
    /// Situations that the variant is best for.
    pub when: String,
}

/// Initial settings of a movie of the lab. book/src/live/movie.js defines the values.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Movie {
    /// Visible layers in addition to speed and touching: bins, asked, list, owners, ghosts,
    /// windows.
    pub layers: Vec<String>,
    /// Method that finds the pairs to test: all, bins, list.
    pub asks: String,
    /// Division of the box among the owners.
    ///
    /// The values are even (equal numbers of rows), equal (equal numbers of particles) and number
    /// (particles by their numbers, without rows).
    pub cut: String,
}

impl Default for Movie {
    fn default() -> Self {
        Self { layers: Vec::new(), asks: "bins".into(), cut: "even".into() }
    }
}

/// Kind of the discs that a program simulates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Discs {
    /// Particles that repel each other within a cutoff.
    #[default]
    Soft,
    /// Discs that collide.
    Hard,
}

/// Kind of an additional program of a lab.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Work {
    /// A simulation of particles that repel each other within a cutoff.
    Soft,
    /// A simulation of discs that collide.
    Hard,
    /// Single loops, which `cargo lab speed` times.
    Loops,
}

/// Workers that share the work of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Workers {
    /// Threads of one process, or one thread.
    #[default]
    Threads,
    /// Processes that exchange messages. They need an MPI library.
    Ranks,
    /// A graphics processor. It needs a Vulkan driver.
    Device,
}

impl Workers {
    /// Returns the software that a reader must have installed.
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
    /// Name of the facts file in a lab's folder.
    pub const FILE: &str = "lab.toml";
}
