//! What a lab says about itself: `[package.metadata.lab]` in its manifest.
//!
//! ```toml
//! [package.metadata.lab]
//! title = "on a graphics processor"
//! discs = "soft"
//! workers = "device"
//! programs = { hard = "hard" }
//! ```

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use serde::Deserialize;

use crate::files::read_toml_at;

/// The facts of a lab.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Facts {
    /// What it is called, such as `all pairs`.
    pub title: String,
    /// What its program simulates.
    pub discs: Discs,
    /// What shares the work.
    pub workers: Workers,
    /// What its other programs simulate, by what stands behind the lab's name in theirs: `hard` for
    /// `lab9-hard`.
    #[serde(default)]
    pub programs: BTreeMap<String, Discs>,
    /// The variant that is the kit's best serial program for such discs, if it is this lab's: what t₁ is
    /// taken from.
    pub baseline: Option<String>,
    /// The variant that `scripts/slurm` runs on 1, 2, 4, … ranks or threads.
    pub cluster: Option<String>,
    /// The variant with threads in each rank, which `scripts/slurm` runs for each split of a node.
    pub hybrid: Option<String>,
    /// The variants that `cargo lab lammps` sets beside LAMMPS.
    #[serde(default)]
    pub lammps: Vec<String>,
    /// What `cargo lab movie` shows of it at first.
    #[serde(default)]
    pub movie: Movie,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Discs {
    /// Particles that repel each other within a cutoff.
    Soft,
    /// Discs that collide.
    Hard,
}

/// What shares the work of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Workers {
    /// Threads of one process, or one thread.
    Threads,
    /// Processes that exchange messages: needs an MPI library.
    Ranks,
    /// A graphics processor: needs a Vulkan driver.
    Device,
}

impl Facts {
    /// The facts of the lab in this folder.
    ///
    /// # Errors
    /// Its manifest cannot be read, or declares no or other facts.
    pub fn read(folder: &Path) -> Result<Self> {
        let path = folder.join("Cargo.toml");
        let facts = read_toml_at(&path, "/package/metadata/lab").context("the lab's facts")?;
        facts.with_context(|| format!("{} has no facts of a lab", path.display()))
    }
}
