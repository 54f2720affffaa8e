//! The measuring commands.

mod complexity;
pub mod contest;
mod count;
mod limits;
pub mod precision;
mod race;
mod scaling;
mod speed;
mod stress;
mod sweep;
mod timeline;
mod traffic;

use std::path::Path;
use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;
use lab_kit::Kit;
use serde_json::Value;

use crate::chart::Sheet;

/// Measure the labs' programs, and judge the measurements.
#[derive(Subcommand)]
#[expect(missing_docs, reason = "the help of a command is its options'")]
pub enum Command {
    Race(race::Options),
    Count(count::Options),
    Limits(limits::Options),
    Speed(speed::Options),
    Complexity(complexity::Options),
    Scaling(scaling::Options),
    Sweep(sweep::Options),
    Timeline(timeline::Options),
    Traffic(traffic::Options),
    Precision(precision::Options),
    Stress(stress::Options),
    Contest(contest::Options),
}

impl Command {
    /// Takes the measurements, then prints the results and writes them to a file.
    ///
    /// # Errors
    /// A measurement fails.
    pub fn run(self, kit: &Kit) -> Result<ExitCode> {
        let done = match self {
            Self::Race(options) => race::run(kit, options),
            Self::Count(options) => count::run(kit, options),
            Self::Limits(options) => limits::run(kit, options),
            Self::Speed(options) => speed::run(kit, options),
            Self::Complexity(options) => complexity::run(kit, options),
            Self::Scaling(options) => scaling::run(kit, options),
            Self::Sweep(options) => sweep::run(kit, options),
            Self::Timeline(options) => timeline::run(kit, options),
            Self::Traffic(options) => traffic::run(kit, options),
            Self::Precision(options) => precision::run(kit, options),
            Self::Stress(options) => return stress::run(kit, options),
            Self::Contest(options) => contest::run(kit, options),
        };
        done.map(|()| ExitCode::SUCCESS)
    }

    /// Returns a figure of the results that the command wrote, and the path of the figure's file.
    ///
    /// Returns `None` if the command draws no figure.
    ///
    /// # Errors
    /// The results are from a different command.
    pub fn redraw(&self, results: &Value) -> Result<Option<(&Path, Sheet)>> {
        match self {
            Self::Race(_) | Self::Count(_) | Self::Speed(_) => Ok(None),
            Self::Limits(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Complexity(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Scaling(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Sweep(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Timeline(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Traffic(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Precision(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Stress(options) => options.files.again(results, |shown| options.draw(shown)),
            Self::Contest(options) => options.files.again(results, |shown| options.draw(shown)),
        }
    }
}
