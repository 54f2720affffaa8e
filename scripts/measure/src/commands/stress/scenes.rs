//! Scenes that are hard for a program.

use common::soft::{CUTOFF, MIN_R, Particle, Scene};
use oracle::scenes;

/// Relative speeds of head-on pairs.
pub(super) const SPEEDS: std::ops::RangeInclusive<u32> = 1..=20;

fn scene(size: f64, particles: Vec<Particle>) -> Scene {
    Scene::new(size, particles).expect("the trials are sound")
}

fn at(x: f64, y: f64, vx: f64, vy: f64) -> Particle {
    Particle { x, y, vx, vy, id: 0 }
}

/// Makes a head-on pair for each speed and phase, each in a separate row.
///
/// A phase is the part of a step after which the two particles come within the cutoff.
pub(super) fn head_on(phases: u32) -> Scene {
    let rows = SPEEDS.count() as u32 * phases;
    let pitch = 3.0 * CUTOFF;
    let size = (f64::from(rows) * pitch).max(2.0);
    let mut particles = Vec::new();
    for speed in SPEEDS {
        for phase in 0..phases {
            let y = (particles.len() as f64 / 2.0 + 0.5) * pitch;
            let w = f64::from(speed);
            let way = w * common::soft::DT * (1.0 + (f64::from(phase) + 0.5) / f64::from(phases));
            let half = 0.5 * (CUTOFF + way);
            particles.push(at(0.5 * size - half, y, 0.5 * w, 0.0));
            particles.push(at(0.5 * size + half, y, -0.5 * w, 0.0));
        }
    }
    scene(size, particles)
}

/// Makes two, three and ten particles at the same position without relative motion, and pairs that
/// are an ulp or less apart.
pub(super) fn one_position() -> Scene {
    let mut particles = Vec::new();
    for (k, count) in [2, 3, 10].into_iter().enumerate() {
        let x = 0.1 + 0.1 * k as f64;
        particles.extend((0..count).map(|_| at(x, 0.1, 0.0, 0.0)));
        particles.extend((0..count).map(|_| at(x, 0.2, 0.3, -0.7)));
    }
    for (k, apart) in [f64::MIN_POSITIVE, 1e-300, 5e-324].into_iter().enumerate() {
        let y = 0.3 + 0.1 * k as f64;
        particles.extend([at(0.0, y, 0.0, 0.0), at(apart, y, 0.0, 0.0)]);
    }
    scene(0.7, particles)
}

/// Makes pairs closer than the least distance of the force, and pairs an ulp below and above it.
pub(super) fn very_close() -> Scene {
    let mut particles = Vec::new();
    let around = [MIN_R.next_down(), MIN_R, MIN_R.next_up()];
    let closer = [1e-17, 1e-12, 1e-9, 1e-6, 0.5 * MIN_R, 2.0 * MIN_R];
    for (row, apart) in around.into_iter().chain(closer).enumerate() {
        let y = 0.05 + 0.1 * row as f64;
        for (column, (dx, dy)) in [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8)].into_iter().enumerate() {
            let x = 0.1 + 0.3 * column as f64;
            particles.push(at(x, y, 0.0, 0.0));
            particles.push(at(x + apart * dx, y + apart * dy, 0.0, 0.0));
        }
    }
    scene(1.0, particles)
}

/// Makes four dense scenes. One particle is fast: 100, 10,000, a million and a billion in the four
/// scenes.
pub(super) fn fast() -> Vec<Scene> {
    let dense = scenes::dense();
    let mut all = Vec::new();
    for speed in [1e2, 1e4, 1e6, 1e9] {
        let mut particles = dense.particles().to_vec();
        particles[17].vx = speed;
        particles[17].vy = -0.7 * speed;
        all.push(scene(dense.size(), particles));
    }
    all
}

/// Makes absurd scenes, which are only required to have finite numbers.
pub(super) fn absurd() -> Vec<Scene> {
    let mut all = Vec::new();
    for (size, v) in [
        (1.0, 1e300),
        (1.0, -1e306),
        (1e-200, 1.0),
        (5e-324, 1.0),
        (1e300, 1e300),
        (0.5 * CUTOFF, 1e-300),
    ] {
        let middle = 0.5 * size;
        let particles = [(0.0, v), (size, -v), (middle, v), (middle, 0.0)];
        all.push(scene(size, particles.map(|(x, v)| at(x, middle, v, -0.3 * v)).to_vec()));
    }
    all
}

/// Makes particles on every wall and corner and an ulp beside them, with velocities in every
/// direction. Some of them are alone, and some touch another particle.
pub(super) fn walls() -> Scene {
    let size: f64 = 1.0;
    let low = [0.0, 5e-324, 1e-300, 1e-17, 1e-9];
    let high = [size, size.next_down(), size - 1e-15, size - 1e-9];
    let positions: Vec<f64> = low.into_iter().chain(high).collect();
    let ways = [(0.0, 0.0), (0.7, 0.2), (-0.7, 0.3), (0.3, -0.9), (-0.2, -0.4)];
    let mut particles = Vec::new();
    for (k, &x) in positions.iter().enumerate() {
        for (way, &(vx, vy)) in ways.iter().enumerate() {
            let along = 0.05 + (k * ways.len() + way) as f64 * 0.019;
            particles.push(at(x, along, vx, vy));
            particles.push(at(along, x, vy, vx));
        }
        // One particle touches a neighbour along the wall, and one is a step inside.
        particles.push(at(x, 0.95, 0.1, 0.0));
        particles.push(at(x, 0.957, -0.1, 0.0));
    }
    for x in [0.0, size] {
        for y in [0.0, size] {
            particles.push(at(x, y, 0.4 - x, 0.9 - y));
        }
    }
    scene(size, particles)
}

/// Makes pairs across the edges and corners of bins, and pairs exactly on the edges and corners.
/// Distances are a cutoff, or an ulp less or more.
pub(super) fn edges() -> Scene {
    let size = 30.0 * CUTOFF;
    let mut particles = Vec::new();
    for row in 0..7_u32 {
        for column in 0..7_u32 {
            let x = f64::from(2 + 4 * column) * CUTOFF;
            let y = f64::from(2 + 4 * row) * CUTOFF;
            let reach = [CUTOFF.next_down(), CUTOFF, CUTOFF.next_up(), 0.9 * CUTOFF];
            let reach = reach[(row + column) as usize % 4];
            let (x, y) = match column % 3 {
                0 => (x.next_down(), y),
                1 => (x, y.next_up()),
                _ => (x, y),
            };
            let slope = 0.5_f64.sqrt();
            let (dx, dy) =
                [(1.0, 0.0), (0.0, 1.0), (slope, slope), (slope, -slope)][row as usize % 4];
            particles.push(at(x, y, 0.3 * dx, 0.3 * dy));
            particles.push(at(x + reach * dx, y + reach * dy, -0.3 * dx, -0.3 * dy));
        }
    }
    scene(size, particles)
}

/// Makes the same twenty-five particles, slightly too close together, near the far corner of a box
/// of side `size`, and in a small box.
pub(super) fn shifted(size: f64) -> Vec<Scene> {
    let small = 0.5;
    // The particles are far from the walls of both boxes.
    let offset = (size - small).floor();
    vec![scene(size, moved(offset)), scene(small, moved(0.0))]
}

fn moved(offset: f64) -> Vec<Particle> {
    let mut particles = Vec::new();
    for k in 0..25_u32 {
        let [x, y] = [k % 5, k / 5].map(|k| offset + 0.2 + 0.95 * CUTOFF * f64::from(k));
        particles.push(at(x, y, 0.3 - 0.1 * f64::from(k % 7), 0.1 * f64::from(k % 5) - 0.2));
    }
    particles
}
