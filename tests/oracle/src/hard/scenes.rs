//! Scenes of hard discs that expose wrong programs.

use common::hard::{Disc, Scene};

use crate::Random;

/// Returns a scene with discs (x, y, vx, vy).
///
/// # Panics
/// If the discs are not a valid scene, which is a mistake in a test.
pub fn of(side: f64, radius: f64, discs: &[(f64, f64, f64, f64)]) -> Scene {
    let discs = discs.iter().map(|&(x, y, vx, vy)| Disc::new(x, y, vx, vy)).collect();
    Scene::new(side, radius, discs).expect("the test's scene is valid")
}

/// Returns `n` discs anywhere in a square of side 100, possibly overlapping. The discs cover the
/// part `fraction` of the square. Velocity components are up to `speed` radii.
pub fn random(n: usize, fraction: f64, speed: f64, seed: u64) -> Scene {
    let side = 100.0;
    let radius = (fraction * side * side / (n as f64 * std::f64::consts::PI)).sqrt();
    anywhere(n, side, radius, speed * radius, seed)
}

fn anywhere(n: usize, side: f64, radius: f64, speed: f64, seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let discs: Vec<_> = (0..n)
        .map(|_| {
            let mut inside = || random.between(radius, side - radius);
            let (x, y) = (inside(), inside());
            (x, y, random.between(-speed, speed), random.between(-speed, speed))
        })
        .collect();
    of(side, radius, &discs)
}

/// Returns 60 to 199 discs anywhere, from sparse to crowded, in a small or a wide square.
pub fn unseen(seed: u64) -> Scene {
    let mut random = Random::new(1000 + seed);
    let n = 60 + random.below(140);
    let fraction = random.between(0.01, 0.4);
    scaled(&self::random(n, fraction, 20.0, seed), random.between(0.5, 20.0))
}

/// Returns discs of radius 1 on some points of an integer lattice, with integer velocities. Such
/// scenes have collisions at exactly the same time, at exactly λ = 0 and λ = 1, and discs at the
/// same position.
pub fn lattice(seed: u64) -> Scene {
    let side = 24.0;
    let mut random = Random::new(seed);
    let mut integer =
        |low: i32, high: i32| f64::from(low) + (random.bits() % (high - low + 1) as u64) as f64;
    let discs: Vec<_> =
        (0..60).map(|_| (integer(1, 23), integer(1, 23), integer(-3, 3), integer(-3, 3))).collect();
    of(side, 1.0, &discs)
}

/// Returns the same scene in a different unit of length.
pub fn scaled(scene: &Scene, by: f64) -> Scene {
    let discs: Vec<_> =
        scene.discs().iter().map(|d| (d.x * by, d.y * by, d.vx * by, d.vy * by)).collect();
    of(scene.side() * by, scene.radius() * by, &discs)
}

/// Returns discs that fly across the whole square in a step or two.
pub fn fast(n: usize, seed: u64) -> Scene {
    anywhere(n, 1000.0, 2.0, 1000.0, seed)
}

/// Returns slow discs in one corner, a few discs far away, and one disc that crosses the square.
pub fn mixed(seed: u64) -> Scene {
    let (side, radius) = (1e7, 1.0);
    let mut random = Random::new(seed);
    let mut discs = Vec::new();
    for k in 0..300 {
        let within = if k < 280 { 60.0 } else { side - 2.0 * radius };
        let (x, y) = (radius + random.between(0.0, within), radius + random.between(0.0, within));
        discs.push((x, y, random.between(-4.0, 4.0), random.between(-4.0, 4.0)));
    }
    discs.push((9e6, 9e6, -8.999_97e6, -8.999_97e6));
    of(side, radius, &discs)
}

/// Returns pairs that nearly miss each other. The path of the second disc passes the first disc at
/// a distance of 2 r (1 − gap), or outside, at 2 r (1 + gap). The gaps are from 1e-3 down to 1e-15.
pub fn grazing() -> Scene {
    let (side, radius) = (4000.0, 1.0);
    let mut discs = Vec::new();
    for k in 0..30 {
        let gap = 10f64.powi(-(k % 15 + 1)) * if k < 15 { 1.0 } else { -1.0 };
        let (x, y) = (100.0 + 60.0 * f64::from(k % 15), 100.0 + 100.0 * f64::from(k / 15));
        discs.push((x, y, 0.0, 0.0));
        discs.push((x - 20.0, y + 2.0 * radius * (1.0 - gap), 30.0, 0.0));
    }
    of(side, radius, &discs)
}

/// Returns the scenes on which every variant must agree, by name.
pub fn all() -> Vec<(&'static str, Scene)> {
    vec![
        ("crowded", random(400, 0.3, 2.0, 1)),
        ("overfull", random(300, 1.5, 1.0, 2)),
        ("thin", random(500, 0.01, 30.0, 3)),
        ("fast", fast(300, 4)),
        ("lattice", lattice(5)),
        ("grazing", grazing()),
        ("tiny units", scaled(&random(200, 0.3, 2.0, 6), 1e-9)),
        ("wide", scaled(&fast(200, 7), 1e4)),
        ("mixed", mixed(8)),
        ("one disc", of(10.0, 1.0, &[(5.0, 5.0, 30.0, -7.0)])),
        ("no room", of(2.0, 1.0, &[(1.0, 1.0, 1.0, 0.0), (1.0, 1.0, -1.0, 0.5)])),
        ("at rest", of(100.0, 1.0, &[(50.0, 50.0, 0.0, 0.0), (50.5, 50.0, 0.0, 0.0)])),
    ]
}
