//! What the time step does to the energy.

use anyhow::Result;
use common::soft::{DT, Scene};
use oracle::{Model, energy};

use lab_measure::chart::{Axis, Chart, Kind, Series};

/// Time that the run takes.
const TIME: f64 = 0.15;

/// The energy of a hundred particles against time, for three time steps.
pub(super) fn time_steps() -> Result<Chart> {
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

/// The change of energy at each time.
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
