//! Times LAMMPS in its best setups and programs of the kit, in turns.

use anyhow::{Context, Result};
use clap::Args;
use common::soft::Scene;
use lab_kit::program::Program;
use lab_measure::clock::{Ratio, Span, Times};
use lab_measure::experiment::in_turns;
use lab_measure::job::Job;
use lab_measure::scene::{self, write_scene};
use serde::Serialize;

use crate::setup::{Lammps, Setup, Style, Tried};

/// Options for the runs that are timed.
#[derive(Args)]
pub(crate) struct Raced {
    /// Numbers of particles for the times, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [10_000, 100_000, 1_000_000])]
    pub(crate) n: Vec<usize>,
    #[command(flatten)]
    pub(crate) tried: Tried,
    /// Number of takes of each engine
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Particle steps of a take; it determines the number of steps at each n
    #[arg(long, default_value_t = 5e7, value_name = "STEPS")]
    work: f64,
    /// Number of workers: ranks of LAMMPS, ranks or threads of the programs
    #[arg(long, value_name = "WORKERS", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    pub(crate) workers: u16,
}

/// An engine that takes turns with other engines.
#[derive(Clone)]
enum Engine {
    Lammps(Setup),
    Ours(Program),
}

/// Times of one engine at one n.
#[derive(Serialize)]
pub(crate) struct Timed {
    #[serde(serialize_with = "named")]
    engine: Engine,
    pub(crate) n: usize,
    pub(crate) steps: u64,
    #[serde(rename = "seconds")]
    pub(crate) times: Times,
    pub(crate) nanoseconds_per_particle_and_step: Span,
    /// Time of the better style that is a part of LAMMPS, divided by this engine's time, for minima
    /// and for medians.
    pub(crate) lammps_best_over_this: Option<Ratio>,
    /// Time of the plugin's style divided by this engine's time.
    pub(crate) plugin_over_this: Option<Ratio>,
}

/// Times at one n.
pub(crate) struct AtN {
    /// Times of every setup of LAMMPS.
    pub(crate) tried: Vec<Timed>,
    /// Times of the best setup of each style and of the programs.
    pub(crate) times: Vec<Timed>,
}

impl Raced {
    /// Tries all setups of LAMMPS, then times the best ones and the programs in turns.
    pub(crate) fn at(&self, n: usize, lammps: &Lammps, programs: &[Program]) -> Result<AtN> {
        let steps = ((self.work / n as f64) as u64).clamp(20, 5000);
        write_scene(&lammps.file("scene.txt"), &Scene::official(n as u64, 1)?)?;
        let seconds = |engine: &Engine| match engine {
            Engine::Lammps(setup) => self.seconds_of(*setup, lammps, steps),
            Engine::Ours(program) => {
                let job = Job::new(program.clone(), scene::Scene::usual(Some(n), false));
                Ok(lammps.runner.run(&Job { steps, workers: self.workers.into(), ..job })?.seconds)
            }
        };
        let setups = lammps.styles().flat_map(|style| self.tried.setups_of(style));
        let setups: Vec<Engine> = setups.map(Engine::Lammps).collect();
        let takes = in_turns(&setups, self.tried.tries.into(), Engine::name, seconds)?;
        let tried = timed(&setups, takes, n, steps);
        let best = Style::ALL.into_iter().filter_map(|style| quickest(&tried, style));
        let engines: Vec<Engine> = best.chain(programs.iter().cloned().map(Engine::Ours)).collect();
        let takes = in_turns(&engines, self.rounds.into(), Engine::name, seconds)?;
        Ok(AtN { tried, times: timed(&engines, takes, n, steps) })
    }

    /// Runs LAMMPS and returns its seconds.
    fn seconds_of(&self, setup: Setup, lammps: &Lammps, steps: u64) -> Result<f64> {
        let start = lammps.file("scene.txt").display().to_string();
        let printed = lammps.run(setup, self.workers, &["time", &start, &steps.to_string()])?;
        printed.trim().parse().context("LAMMPS printed no time")
    }
}

/// Returns the setup of this style with the shortest time; `None` if the style was not tried.
fn quickest(tried: &[Timed], style: Style) -> Option<Engine> {
    let of_style = tried.iter().filter(|timed| timed.engine.style() == Some(style));
    Some(of_style.min_by(|a, b| a.times.min.total_cmp(&b.times.min))?.engine.clone())
}

/// Summarises the times of each engine.
fn timed(engines: &[Engine], takes: Vec<Vec<f64>>, n: usize, steps: u64) -> Vec<Timed> {
    let mut all = Vec::new();
    for (engine, takes) in engines.iter().zip(takes) {
        let Some(times) = Times::of(takes) else { continue };
        all.push(Timed {
            engine: engine.clone(),
            n,
            steps,
            nanoseconds_per_particle_and_step: times.span(1e9 / (n as f64 * steps as f64)),
            lammps_best_over_this: None,
            plugin_over_this: None,
            times,
        });
    }
    let best = least(&all, Style::is_of_lammps);
    let plugin = least(&all, |style| !style.is_of_lammps());
    for timed in &mut all {
        let span = timed.times.span(1.0);
        timed.lammps_best_over_this = best.map(|best| best.over(span));
        timed.plugin_over_this = plugin.map(|plugin| plugin.over(span));
    }
    all
}

/// Returns LAMMPS's least times among the styles that `of` accepts; `None` if no such style ran.
///
/// The least minimum and the least median may belong to different styles. Both show how fast LAMMPS
/// can be. With the same style for both, one time would be unfair to LAMMPS.
fn least(all: &[Timed], of: fn(Style) -> bool) -> Option<Span> {
    let lammps = all.iter().filter(|timed| timed.engine.style().is_some_and(of));
    Span::least(lammps.map(|timed| timed.times.span(1.0)))
}

impl Engine {
    /// Returns LAMMPS's pair style; `None` for a program of the kit.
    fn style(&self) -> Option<Style> {
        match self {
            Self::Lammps(setup) => Some(setup.style),
            Self::Ours(_) => None,
        }
    }

    fn name(&self) -> String {
        match self {
            Self::Lammps(setup) => setup.to_string(),
            Self::Ours(program) => program.to_string(),
        }
    }
}

impl Timed {
    /// Returns the engine's name.
    pub(crate) fn name(&self) -> String {
        self.engine.name()
    }
}

fn named<S: serde::Serializer>(engine: &Engine, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&engine.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Walls;

    fn lammps(style: Style, skin: f64) -> Engine {
        Engine::Lammps(Setup { style, skin, sort: 20, delay: 0, walls: Walls::All })
    }

    #[test]
    fn lammps_has_its_best_setup_by_minima_and_by_medians() {
        let ours = Program::new("10".parse().expect("a lab"), true).expect("a lab");
        let engines = [
            lammps(Style::Lepton, 0.01),
            lammps(Style::Table, 0.01),
            lammps(Style::Table, 0.02),
            lammps(Style::SoftDisc, 0.02),
            Engine::Ours(ours),
        ];
        let takes =
            [[4.0, 9.0, 9.5], [7.0, 7.0, 8.0], [6.0, 7.0, 8.0], [3.0, 3.0, 3.0], [1.0, 1.5, 2.0]];
        let all = timed(&engines, takes.map(Vec::from).to_vec(), 10, 10);
        let best = least(&all, Style::is_of_lammps).expect("LAMMPS ran");
        assert_eq!((best.min, best.median), (4.0, 7.0));
        assert!(least(&all[3..], Style::is_of_lammps).is_none(), "neither is a style of LAMMPS");
        let plugin = all[4].plugin_over_this.expect("the plugin ran");
        assert_eq!((plugin.of_minima, plugin.of_medians), (3.0, 2.0));
        let quickest = quickest(&all, Style::Table).expect("there is a table");
        assert_eq!(quickest.name(), "LAMMPS table, skin 0.02, sort 20, delay 0, walls all");
    }
}
