//! Scenes that expose wrong programs.
//!
//! The official scene exposes too few mistakes. Nine out of ten particles have no neighbour, and
//! eight of 32 typical wrong programs pass the original checker on it. The scenes here expose more
//! mistakes.

use common::soft::{CUTOFF, Particle, Scene};

use crate::Random;

/// Returns scene A: the official scene with 1000 particles and seed 1.
pub fn official() -> Scene {
    Scene::official(1000, 1).expect("the official scene is valid")
}

/// Returns scene B: 150 particles in a box of 10.3 cutoffs, with 4.4 neighbours each, all in
/// motion.
pub fn dense() -> Scene {
    dense_with_seed(1)
}

/// Returns a scene like B with a different seed.
pub fn dense_with_seed(seed: u64) -> Scene {
    lattice_with_jitter(150, 10.3 * CUTOFF, 1.0, seed)
}

/// Returns two particles exactly a cutoff from a third, along x and along y, at rest.
pub fn at_the_cutoff() -> Scene {
    let at = |x: f64, y: f64| Particle { x: x * CUTOFF, y: y * CUTOFF, ..Particle::default() };
    let particles = vec![at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
    Scene::new(2.0 * CUTOFF, particles).expect("all particles are in the box")
}

/// Returns the example of chapters 5 and 6: a dozen particles before a step and after it. The box
/// of side 6 has six rows of bins of side 1.
///
/// Particles 2r and 2r + 1 begin in row r. With two rows per rank, particle 1 changes its row
/// within the block. Particles 3 and 8 cross to the next block. Particle 11 flies from the last row
/// to the first.
pub fn dozen() -> [Vec<Particle>; 2] {
    // Positions. Particles that begin in the same row of bins share a line.
    #[rustfmt::skip]
    const BEFORE: [(f64, f64); 12] = [
        (4.3, 0.6), (1.4, 0.7),
        (2.4, 1.5), (3.6, 1.7),
        (0.6, 2.7), (2.1, 2.3),
        (1.5, 3.5), (5.3, 3.3),
        (3.6, 4.3), (1.4, 4.6),
        (3.4, 5.5), (5.4, 5.4),
    ];
    #[rustfmt::skip]
    const AFTER: [(f64, f64); 12] = [
        (4.4, 0.5), (1.5, 1.2),
        (2.5, 1.6), (3.7, 2.2),
        (0.7, 2.6), (2.9, 2.4),
        (1.6, 3.6), (5.2, 3.2),
        (3.5, 3.8), (1.3, 4.5),
        (3.3, 5.4), (5.5, 0.4),
    ];
    [BEFORE, AFTER].map(|positions| {
        let particle = |(id, (x, y))| Particle { x, y, id, ..Particle::default() };
        (0..).zip(positions).map(particle).collect()
    })
}

/// Returns `n` particles spread over a box of side `size`. All positions are different. Velocity
/// components are up to `speed`.
pub fn lattice_with_jitter(n: usize, size: f64, speed: f64, seed: u64) -> Scene {
    spread(&mut Random::new(seed), n, size, speed)
}

/// Draws `n` particles spread over a box, in random order. Each particle has its own part of the
/// box.
pub fn spread(random: &mut Random, n: usize, size: f64, speed: f64) -> Scene {
    let columns = (n as f64).sqrt().ceil() as usize;
    let pitch = size / columns as f64;
    let mut squares: Vec<usize> = (0..columns * columns).collect();
    // The squares are shuffled, so that positions do not depend on ids.
    random.shuffle(&mut squares);
    let particles = squares.into_iter().take(n).map(|square| Particle {
        x: ((square % columns) as f64 + random.between(0.1, 0.9)) * pitch,
        y: ((square / columns) as f64 + random.between(0.1, 0.9)) * pitch,
        vx: random.between(-speed, speed),
        vy: random.between(-speed, speed),
        id: 0,
    });
    scene(size, particles.collect())
}

/// Draws `n` particles anywhere in a box.
pub fn anywhere(random: &mut Random, n: usize, size: f64, speed: f64) -> Scene {
    let particles = (0..n).map(|_| Particle {
        x: random.between(0.0, size),
        y: random.between(0.0, size),
        vx: random.between(-speed, speed),
        vy: random.between(-speed, speed),
        id: 0,
    });
    scene(size, particles.collect())
}

/// Draws `n` particles at rest in a box with `along` bins along a wall, on walls, in corners, on
/// edges of bins and anywhere. Some particles have the position of the previous particle.
pub fn on_edges(random: &mut Random, n: usize, size: f64, along: usize) -> Vec<Particle> {
    let mut particles: Vec<Particle> = Vec::with_capacity(n);
    for id in 0..n as u32 {
        let at = match particles.last() {
            Some(before) if random.below(5) == 0 => *before,
            _ => {
                let (x, y) = (random.coordinate(size, along), random.coordinate(size, along));
                Particle { x, y, ..Particle::default() }
            }
        };
        particles.push(Particle { id, ..at });
    }
    particles
}

/// Returns scene C: a crowd of 200 particles anywhere in a box of 2.55 cutoffs, with 60 neighbours
/// each. Some particles are so close to others that they fly through the box many times in one
/// step.
pub fn crowd(seed: u64) -> Scene {
    anywhere(&mut Random::new(seed), 200, 2.55 * CUTOFF, 1.0)
}

/// Returns a dense box in which nearly every particle changes its bin in every step, because it
/// moves two cutoffs per step.
pub fn all_leave() -> Scene {
    lattice_with_jitter(150, 10.3 * CUTOFF, 40.0, 5)
}

/// Returns the dense box inside a wide box, at the wide box's left wall and `y` above its bottom.
pub fn corner(y: f64) -> Scene {
    in_a_wide_box(|p| Particle { y: p.y + y, ..*p })
}

/// Returns the dense box inside a wide box, through which all particles fly from the bottom to the
/// top.
pub fn drifting() -> Scene {
    in_a_wide_box(|p| Particle { vy: 20.0, ..*p })
}

fn in_a_wide_box(change: impl Fn(&Particle) -> Particle) -> Scene {
    scene(60.0 * CUTOFF, dense().particles().iter().map(change).collect())
}

/// Returns 40 particles in one row of bins. The other rows are empty.
pub fn one_row() -> Scene {
    scene(0.4, (0..40).map(|k| at_rest(0.007 * f64::from(k), 0.2049)).collect())
}

/// Returns scenes D: isolated pairs at 0.9995 cutoffs, across every edge and corner of bins. The
/// pairs have all directions; the box is 30.55 cutoffs wide. Bins may be as wide as the cutoff or
/// as wide as the box allows. Bins of a different width have an edge at some pair too.
pub fn edges() -> Vec<Scene> {
    let size = 30.55 * CUTOFF;
    let half = 0.9995 * CUTOFF / 2.0;
    let diagonal = half / 2.0_f64.sqrt();
    // Pairs that cross only one edge are a quarter of a bin away from the corner.
    let directions = [
        (half, 0.0, 0.0, 0.25),
        (0.0, half, 0.25, 0.0),
        (diagonal, diagonal, 0.0, 0.0),
        (diagonal, -diagonal, 0.0, 0.0),
    ];
    let mut scenes = Vec::new();
    for pitch in [CUTOFF, size / 30.0] {
        for (dx, dy, off_x, off_y) in directions {
            // Only every third edge has pairs, so that pairs do not meet other pairs. Nine scenes
            // cover all edges.
            for (first_column, first_row) in (0..9).map(|k| (k % 3, k / 3)) {
                let mut particles = Vec::new();
                for row in (first_row..=30).step_by(3) {
                    for column in (first_column..=30).step_by(3) {
                        let x = (f64::from(column) + off_x) * pitch;
                        let y = (f64::from(row) + off_y) * pitch;
                        let mut pair = [(x - dx, y - dy), (x + dx, y + dy)];
                        if (row + column) % 2 == 1 {
                            pair.reverse();
                        }
                        if pair.iter().all(|&(x, y)| inside(x, size) && inside(y, size)) {
                            particles.extend(pair.map(|(x, y)| at_rest(x, y)));
                        }
                    }
                }
                scenes.push(scene(size, particles));
            }
        }
    }
    scenes
}

/// Returns scene E: pairs at 0, 0.003 and 0.005 cutoffs, and one particle on each wall and corner.
/// The distances are below the least distance of the force.
pub fn close_pairs() -> Scene {
    let size = 20.0 * CUTOFF;
    let mut particles = Vec::new();
    for (row, distance) in [0.0, 0.003, 0.005].into_iter().enumerate() {
        for (column, (dx, dy)) in [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8)].into_iter().enumerate() {
            let (x, y) = ((4 + 5 * column) as f64 * CUTOFF, (4 + 5 * row) as f64 * CUTOFF);
            particles.push(at_rest(x, y));
            particles.push(at_rest(x + distance * CUTOFF * dx, y + distance * CUTOFF * dy));
        }
    }
    for (x, y) in [(0.0, 0.0), (size, 0.0), (0.0, size), (size, size), (size / 2.0, size)] {
        particles.push(at_rest(x, y));
    }
    scene(size, particles)
}

/// Returns scenes F: velocities of 900 and -750. A step takes the particles through the first box
/// once or twice, and through the second about twenty times.
pub fn fast() -> [Scene; 2] {
    [0.3, 2.3 * CUTOFF].map(|size| {
        let mut random = Random::new(6);
        let mut particles = Vec::new();
        for (vx, vy) in [(900.0, -750.0), (-750.0, 900.0), (900.0, 0.0), (0.0, -750.0)] {
            for _ in 0..5 {
                let (x, y) = (random.between(0.0, size), random.between(0.0, size));
                particles.push(Particle { x, y, vx, vy, id: 0 });
            }
        }
        scene(size, particles)
    })
}

/// Returns a crowd of `n` particles at rest within `extent` cutoffs, for forces and momentum. The
/// box is so large that particles do not reach a wall.
pub fn cloud(n: usize, extent: f64, seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let size = 1e4 * CUTOFF;
    let mut near = || size / 2.0 + random.between(-extent, extent) * CUTOFF / 2.0;
    let particles = (0..n).map(|_| at_rest(near(), near())).collect();
    scene(size, particles)
}

fn inside(x: f64, size: f64) -> bool {
    (0.0..=size).contains(&x)
}

fn at_rest(x: f64, y: f64) -> Particle {
    Particle { x, y, ..Particle::default() }
}

fn scene(size: f64, particles: Vec<Particle>) -> Scene {
    Scene::new(size, particles).expect("the test scene is valid")
}
