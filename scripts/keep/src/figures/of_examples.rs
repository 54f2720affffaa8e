//! Figures of the numbers that the engines' examples have written.

use std::path::Path;

use anyhow::Result;
use lab_measure::chart::{Axis, Chart, Kind, Series, Sheet, number};
use lab_measure::numbers::DataFile;
use serde::Deserialize;

/// A file in book/data, whose figure has the same name, and the function that draws it.
type Figure = (&'static str, fn(&Path) -> Result<Sheet>);

/// All figures of examples.
pub(super) const CHARTS: [Figure; 3] =
    [("lab7-greedy", greedy), ("lab6-model", model), ("lab13-model", model)];

/// Numbers of the example `greedy` of hard-discs.
#[derive(Deserialize)]
struct Losses {
    steps: Vec<Loss>,
}

#[derive(Deserialize)]
struct Loss {
    way_in_radii: f64,
    collisions: f64,
    exact_collisions: f64,
    error_in_radii: f64,
}

/// Plots the error of positions and the share of collisions that the rule keeps against the step.
fn greedy(file: &Path) -> Result<Sheet> {
    let losses = Losses::deserialize(DataFile::read(file)?.results)?.steps;
    let errors = losses.iter().map(|loss| (loss.way_in_radii, loss.error_in_radii)).collect();
    let kept = losses
        .iter()
        .map(|loss| (loss.way_in_radii, 100.0 * loss.collisions / loss.exact_collisions));
    let series = "one collision a step, the earliest";
    let error = Chart::new(
        "How far off the discs end, against the step",
        Axis::log("distance in a step / r"),
        Axis::log("mean error of positions / r"),
    );
    let collisions = Chart::new(
        "How many collisions are kept",
        Axis::log("distance in a step / r"),
        Axis::linear("collisions kept [%]").starting_at(0.0),
    );
    Ok(vec![vec![
        error.with(Series::new(Kind::Measured, series, errors)),
        collisions.with(Series::new(Kind::Measured, series, kept.collect())),
    ]])
}

/// Numbers of the example `model` of strips.
#[derive(Deserialize)]
struct Curves {
    curves: Vec<Curve>,
}

#[derive(Deserialize)]
struct Curve {
    name: String,
    nanoseconds_per_particle_and_step: f64,
    strong: Vec<Point>,
    weak: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    ranks: f64,
    n: f64,
    seconds_per_step: [f64; 3],
    efficiency: [f64; 3],
}

/// Plots strong and weak scaling against the number of ranks. The charts show the time of a step
/// for a scene of fixed size, and the efficiency for scenes that grow.
fn model(file: &Path) -> Result<Sheet> {
    let curves = Curves::deserialize(DataFile::read(file)?.results)?.curves;
    let halo = &curves[1];
    let most = halo.strong.iter().map(|point| point.ranks).fold(0.0, f64::max);
    // Each label is four times the one before, so that labels have enough room.
    let powers = std::iter::successors(Some(1.0), |p| Some(4.0 * p));
    let ranks = Axis::log("ranks").with_ticks(powers.take_while(|p| *p <= most));
    let mut strong = Chart::new(
        format!("Model: n = {}, band over three networks", number(halo.strong[0].n)),
        ranks.clone(),
        Axis::log("time of a step [s]"),
    );
    let mut weak = Chart::new(
        format!("Model: weak scaling, {} per rank", number(halo.weak[0].n)),
        ranks,
        Axis::linear("efficiency").starting_at(0.0),
    );
    for curve in &curves {
        let seconds = curve.strong.iter().map(|point| (point.ranks, point.seconds_per_step));
        strong = strong.with(banded(&curve.name, seconds));
        let efficiencies = curve.weak.iter().map(|point| (point.ranks, point.efficiency));
        weak = weak.with(banded(&curve.name, efficiencies));
    }
    let cost = 1e-9 * halo.nanoseconds_per_particle_and_step;
    let ideal = halo.strong.iter().map(|point| (point.ranks, cost * point.n / point.ranks));
    let one = halo.weak.iter().map(|point| (point.ranks, 1.0));
    Ok(vec![vec![
        strong.with(Series::new(Kind::Guide, "ideal", ideal.collect())),
        weak.with(Series::new(Kind::Guide, "ideal", one.collect())),
    ]])
}

/// Makes a line for the second network, and a band that covers all three networks.
fn banded(name: &str, values: impl Iterator<Item = (f64, [f64; 3])>) -> Series {
    let mut line = Vec::new();
    let mut band = Vec::new();
    for (ranks, mut of_networks) in values {
        line.push((ranks, of_networks[1]));
        of_networks.sort_by(f64::total_cmp);
        band.push((ranks, of_networks[0], of_networks[2]));
    }
    Series::new(Kind::Model, name, line).with_band(band)
}
