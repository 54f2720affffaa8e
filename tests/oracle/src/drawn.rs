//! Random scenes for questions.

use std::f64::consts::TAU;

use common::soft::{CUTOFF, MIN_R, Particle, Scene};

use crate::Random;
use crate::scenes::anywhere;

/// Draws 81 isolated pairs at 0.9995 cutoffs, in any direction. Each pair is across an edge between
/// bins that are one cutoff wide.
///
/// # Panics
/// Never: all particles are in the box.
pub fn pairs_over_edges(random: &mut Random) -> Scene {
    let middle = |at: usize| (4 * at + 3) as f64 * CUTOFF;
    let mut particles = Vec::new();
    for index in 0..81 {
        let x = middle(index % 9);
        let y = middle(index / 9);
        let (sin, cos) = random.between(0.0, TAU).sin_cos();
        for half in [-0.499_75 * CUTOFF, 0.499_75 * CUTOFF] {
            particles.push(Particle {
                x: x + half * cos,
                y: y + half * sin,
                ..Particle::default()
            });
        }
    }
    Scene::new(40.55 * CUTOFF, particles).expect("all particles are in the box")
}

/// Draws about 60 particles in a small box. Two are at the same position, and two almost at the
/// same position.
///
/// # Panics
/// Never: all particles are in the box.
pub fn heap(random: &mut Random) -> Scene {
    let size = 2.55 * CUTOFF;
    let n = 40 + random.below(40);
    let mut particles = anywhere(random, n, size, 1.0).particles().to_vec();
    (particles[1].x, particles[1].y) = (particles[0].x, particles[0].y);
    (particles[3].x, particles[3].y) = (particles[2].x, (particles[2].y + 0.4 * MIN_R).min(size));
    Scene::new(size, particles).expect("all particles are in the box")
}
