//! Charts of the model: the force and the potential of a pair, and the energy for different time
//! steps.

use anyhow::Result;
use common::soft::{CUTOFF, DT, MASS, MIN_R, Scene};
use oracle::{Model, acceleration_of_pair, energy, potential_of_pair};

use lab_measure::chart::{Axis, Chart, Kind, Series};

/// A figure's file, and the function that draws it.
type Figure = (&'static str, fn() -> Result<Chart>);

/// All charts of the model.
pub(super) const CHARTS: [Figure; 3] =
    [("force.svg", force), ("potential.svg", potential), ("energy.svg", time_steps)];

/// Plots the change that one neighbour makes to a particle's velocity in a step against the
/// distance.
fn force() -> Result<Chart> {
    // Points are evenly spaced on a logarithmic axis, and denser close to the cutoff, where the
    // force ends.
    let mut points: Vec<(f64, f64)> = (0..=240)
        .map(|k| 10f64.powf(-3.0 + f64::from(k) / 80.0))
        .chain((1..=6).map(|k| 1.0 - 10f64.powi(-k)))
        .chain([MIN_R / CUTOFF])
        .map(|r| (r, acceleration_of_pair(r * CUTOFF, 0.0).x.abs() * DT))
        .filter(|(_, change)| *change > 1e-3)
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let speed = vec![(1e-3, 1.0), (1.0, 1.0)];
    Ok(Chart::new(
        "What one neighbour does to a particle",
        Axis::log("distance r / c"),
        Axis::log("change of velocity in a step"),
    )
    .with(Series::new(Kind::Model, "|a| dt", points))
    .with(Series::new(Kind::Guide, "velocity 1, as fast as most particles are", speed)))
}

/// Plots the potential of a pair against its distance. Lines show the energies of an average pair
/// and of the fastest pair.
fn potential() -> Result<Chart> {
    let points: Vec<(f64, f64)> = (0..=150)
        .map(|k| 0.75 + f64::from(k) * 0.002)
        .map(|r| (r, potential_of_pair(r * CUTOFF, 0.0)))
        .collect();
    // Velocity components are uniform in -1 to 1, so their mean square is 1/3. The square of the
    // difference of two velocities is therefore 4/3 on average and at most 8.
    let levels = [4.0 / 3.0, 8.0].map(|squared| MASS / 2.0 * squared / 2.0);
    let [average, most] = levels.map(|energy| vec![(0.75, energy), (1.05, energy)]);
    Ok(Chart::new(
        "The work to push two particles together, and what pairs bring",
        Axis::linear("distance r / c"),
        Axis::linear("potential U"),
    )
    .with(Series::new(Kind::Model, "U(r)", points))
    .with(Series::new(Kind::Model, "average pair, at most", average))
    .with(Series::new(Kind::Model, "fastest pair, head-on", most))
    .labelled_directly())
}

/// Total time of a run.
const TIME: f64 = 0.15;

/// Plots the energy of a hundred particles against time for three time steps.
fn time_steps() -> Result<Chart> {
    let mut chart = Chart::new(
        "What the time step does to the energy of 100 particles",
        Axis::linear("time"),
        Axis::linear("change of the energy [%]"),
    );
    for (name, parts) in
        [("time step 0.0005, the official", 1.0), ("half of it", 2.0), ("a quarter", 4.0)]
    {
        chart = chart.with(Series::new(Kind::Model, name, run(DT / parts)?));
    }
    Ok(chart)
}

/// Returns the change of energy at each time.
fn run(dt: f64) -> Result<Vec<(f64, f64)>> {
    let mut model = Model::new(&Scene::official(100, 1)?);
    let start = energy(&model.particles);
    let steps = (TIME / dt).round() as usize;
    let mut points = Vec::new();
    for step in 0..=steps {
        points.push((step as f64 * dt, 100.0 * (energy(&model.particles) / start - 1.0)));
        model.advance(dt);
    }
    Ok(points)
}
