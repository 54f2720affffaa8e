//! `cargo lab contest`: an entry's place in the plane of run time and error.
//!
//! In each round, a seed draws a scene of each kind ([`oracle::contest`]). The reference engine and
//! all entries run it in turns. Time and error come from the same run, so a program gains nothing
//! if it is fast only when timed and exact only when checked.

mod class_page;
mod entry;
mod racing;
mod ranking;
mod show;
mod trial;

use std::hash::{BuildHasher, RandomState};
use std::path::PathBuf;
use std::time::Duration;

use anyhow::{Result, ensure};
use clap::Args;
use lab_kit::Kit;
use lab_kit::machine::cores;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

use crate::cachegrind::Caches;
use crate::chart::Sheet;
use crate::numbers::{DataFile, Files};
use crate::runner::Runner;
pub use class_page::publish;
pub use entry::Entry;
pub use racing::Contest;
pub use ranking::unranked;
use trial::by;
pub use trial::{Drawn, Track};

/// The reference engine, which takes official steps. Times in the contest are multiples of its
/// time.
pub const REFERENCE: &str = "solution2:sorted";

/// Measurements of the kit's own engines, which this command has written.
const LANDMARKS: &str = "book/data/lab14-landmarks.json";

/// Show an entry's place in the plane of run time and error (lab 14)
///
/// Measures your lab 14, or the programs that you name, in about two minutes. Every round draws new
/// scenes of five kinds. Each entry takes turns with solution2:sorted, and its time is a multiple of
/// sorted's time. Its error is the rms distance from the exact positions after 100 official steps, as a
/// multiple of the official step's error. A time or error for all kinds is the geometric mean. An
/// entry that loses a particle, leaves the box, needs more memory with every step, or ends elsewhere in
/// a second run is shown with the reason and is not ranked.
///
/// With `--class` nothing is measured. The command reads results that it wrote with `--json`, and writes a
/// page for the class with the plane, in which entries have numbers, and a list of points.
#[derive(Args)]
pub struct Options {
    /// The programs, such as lab14 or solution10 [default: lab14]
    #[arg(value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Use small scenes and one round, to see that the command works
    #[arg(long)]
    quick: bool,
    /// Seed of the first round's scenes [default: from the clock]
    #[arg(long, value_name = "SEED", value_parser = clap::value_parser!(u32).range(1..=4_000_000_000))]
    seed: Option<u32>,
    /// Number of rounds, each with new scenes
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u32).range(1..=100))]
    rounds: u32,
    /// Number of threads that an entry may use [default: one per core]
    #[arg(short, value_name = "THREADS", value_parser = clap::value_parser!(u16).range(1..))]
    t: Option<u16>,
    /// Greatest time of a run in seconds
    #[arg(long, default_value_t = 60, value_name = "SECONDS")]
    limit: u64,
    /// Make the page of a class from the files NAME.json in this folder (for instructors)
    #[arg(long, value_name = "FOLDER", exclusive = true)]
    class: Option<PathBuf>,
    #[command(flatten)]
    caches: Caches,
    #[command(flatten)]
    pub(super) files: Files,
}

/// All results of the command: the entries, and the settings that the results depend on.
#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    seed: u32,
    threads: usize,
    entries: Vec<Entry>,
    /// The kit's own engines as they were measured once; empty in a file of landmarks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    landmarks: Vec<Entry>,
}

impl Options {
    pub(super) fn draw(&self, shown: Results) -> Result<Sheet> {
        Ok(vec![vec![show::chart(&shown.entries, &shown.landmarks)]])
    }
}

pub(super) fn run(kit: &Kit, mut options: Options) -> Result<()> {
    if let Some(folder) = &options.class {
        return class_page::write(kit, folder);
    }
    if options.quick {
        options.rounds = 1;
    }
    if options.programs.is_empty() {
        options.programs.push("lab14".parse().map_err(anyhow::Error::msg)?);
    }
    ensure!(!options.programs.iter().any(Program::is_hard), "the contest is about soft discs");
    let reference: Program = REFERENCE.parse().map_err(anyhow::Error::msg)?;
    let packages = [&options.programs[..], std::slice::from_ref(&reference)].concat();
    let mut runner = Runner::build(kit, &packages)?;
    runner.limit = Duration::from_secs(options.limit);
    let variants = runner.variants(&options.programs)?;
    let clock = RandomState::new().hash_one(()) as u32 % 1_000_000 + 1;
    let contest = Contest {
        reference,
        threads: options.t.map_or_else(cores, usize::from),
        shrink: if options.quick { 20 } else { 1 },
        seed: options.seed.unwrap_or(clock),
    };
    let scenes = contest.scenes(options.rounds)?;
    let mut entries: Vec<Entry> = variants.into_iter().map(|(one, _)| Entry::new(one)).collect();
    contest.measure(&by(&runner), &scenes, &mut entries)?;
    contest.count(&mut runner, options.caches, options.rounds, &mut entries)?;
    let seed = contest.seed;
    let landmarks = landmarks(kit, &entries);
    println!("{}", show::tables(&entries, &landmarks));
    println!(
        "Rounds: {}. Scenes from seed {seed} on, up to {} threads{}",
        options.rounds,
        contest.threads,
        if options.quick { "; small scenes, so the numbers say little" } else { "" }
    );
    let results = Results { seed, threads: contest.threads, entries, landmarks };
    options.files.write(results, |shown| options.draw(shown))
}

/// Reads the landmarks; empty if the kit has none. A landmark that is also an entry of this contest
/// is omitted.
fn landmarks(kit: &Kit, entries: &[Entry]) -> Vec<Entry> {
    let file = DataFile::read(&kit.path(LANDMARKS)).ok();
    let results = file.and_then(|file| Results::deserialize(file.results).ok());
    let mut landmarks = results.map_or_else(Vec::new, |results| results.entries);
    landmarks.retain(|old| entries.iter().all(|entry| entry.program != old.program));
    landmarks
}
