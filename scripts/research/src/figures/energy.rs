//! What the time step does to the energy.

use anyhow::Result;
use common::soft::{CUTOFF, DT, MASS, Particle, Scene};
use oracle::{acceleration_of_pair, fold, potential_of_pair};

use lab_measure::chart::{Axis, Chart, Series};

/// Time that the run takes.
const TIME: f64 = 0.15;

/// The energy of a hundred particles against time, for three time steps.
pub(super) fn time_steps() -> Result<String> {
    let mut chart = Chart::new(
        "What the time step does to the energy of 100 particles",
        Axis::linear("time"),
        Axis::linear("change of the energy [%]"),
    );
    for (name, parts) in
        [("time step 0.0005, the official", 1.0), ("half of it", 2.0), ("a quarter", 4.0)]
    {
        chart = chart.with(Series::model(name, run(DT / parts)?));
    }
    Ok(chart.svg())
}

/// The change of energy at each time.
fn run(dt: f64) -> Result<Vec<(f64, f64)>> {
    let scene = Scene::official(100, 1)?;
    let mut particles = scene.particles().to_vec();
    let start = energy(&particles);
    let steps = (TIME / dt).round() as usize;
    let mut points = Vec::new();
    for step in 0..=steps {
        points.push((step as f64 * dt, 100.0 * (energy(&particles) / start - 1.0)));
        advance(&mut particles, scene.size(), dt);
    }
    Ok(points)
}

fn advance(particles: &mut [Particle], size: f64, dt: f64) {
    let before = particles.to_vec();
    for particle in particles.iter_mut() {
        for neighbour in &before {
            let d = before[particle.id as usize].to(neighbour);
            let a = acceleration_of_pair(d.x, d.y);
            particle.vx += a.x * dt;
            particle.vy += a.y * dt;
        }
        (particle.x, particle.vx) = fold(particle.x + particle.vx * dt, particle.vx, size);
        (particle.y, particle.vy) = fold(particle.y + particle.vy * dt, particle.vy, size);
    }
}

fn energy(particles: &[Particle]) -> f64 {
    let kinetic = particles.iter().map(|p| MASS * p.vx.hypot(p.vy).powi(2) / 2.0).sum::<f64>();
    let pairs = particles.iter().enumerate().flat_map(|(i, p)| {
        particles[i + 1..].iter().map(|q| p.to(q)).filter(|d| d.x.abs().max(d.y.abs()) <= CUTOFF)
    });
    kinetic + pairs.map(|d| potential_of_pair(d.x, d.y)).sum::<f64>()
}
