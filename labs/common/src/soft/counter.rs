//! The counter scene, in which any particle is computed from its number alone.
//!
//! The official generator makes its particles one after the other, and must store the whole
//! shuffle. So every process that wants a part of the scene must generate the whole scene, in
//! memory that grows with the scene. The counter scene needs no memory. Its distribution is the
//! same: the same sites, each taken once, in shuffled order, and speeds from -1 to 1. Only the
//! random numbers differ.

use std::ops::Range;

use super::lattice::Lattice;
use super::official::unit_speed;
use super::philox::philox4x32;
use super::shuffle::Shuffle;
use super::{Particle, Scene, SceneError};
use crate::room::room_for;

/// Number of the generator's stream that speeds come from. The shuffle uses stream 0.
const SPEEDS: u32 = 1;

/// The particles of a counter scene, each of which can be computed without the others.
///
/// The struct stores only n and a seed. Particles can be computed from their ids, or row by row of
/// the lattice at the start. So a process that has a part of the box makes only the particles of
/// its part. Time and memory grow with the part.
#[derive(Clone, Copy, Debug)]
pub struct CounterParticles {
    lattice: Lattice,
    shuffle: Shuffle,
    seed: u32,
}

impl Scene {
    /// Makes the counter scene of `n` particles.
    ///
    /// # Errors
    /// The same as those of [`Scene::official`].
    pub fn counter(n: u64, seed: u32) -> Result<Self, SceneError> {
        let scene = CounterParticles::new(n, seed)?;
        let mut particles = room_for(scene.count()).ok_or(SceneError::Memory("particle", n))?;
        particles.extend((0..scene.count()).map(|id| scene.particle(id)));
        Self::new(scene.size(), particles)
    }
}

impl CounterParticles {
    /// Makes the scene of `n` particles.
    ///
    /// # Errors
    /// `n` is 0 or beyond [`Scene::MOST`], or the seed is 0.
    pub fn new(n: u64, seed: u32) -> Result<Self, SceneError> {
        let count = Scene::check_count(n)?;
        if seed == 0 {
            return Err(SceneError::SeedZero);
        }
        let lattice = Lattice::new(count);
        let shuffle = Shuffle::new(count, lattice.columns, lattice.rows, seed);
        Ok(Self { lattice, shuffle, seed })
    }

    /// Returns the number of particles.
    pub fn count(&self) -> usize {
        self.lattice.n
    }

    /// Returns the side of the box.
    pub fn size(&self) -> f64 {
        self.lattice.size
    }

    /// Returns particle `id`, which is in 0 .. [`count`](Self::count).
    pub fn particle(&self, id: usize) -> Particle {
        self.at(id, self.shuffle.forward(id))
    }

    /// Returns the number of rows of particles, nearly √n.
    pub fn rows(&self) -> usize {
        self.lattice.rows
    }

    /// Returns y of all particles of `row`. Higher rows have a greater y.
    pub fn y(&self, row: usize) -> f64 {
        self.lattice.y(row)
    }

    /// Returns the number of particles in `rows`.
    pub fn count_in(&self, rows: Range<usize>) -> usize {
        self.sites(rows).len()
    }

    /// Returns the particles in `rows`, in the order of their sites.
    pub fn in_rows(&self, rows: Range<usize>) -> impl Iterator<Item = Particle> {
        self.sites(rows).map(|site| self.at(self.shuffle.backward(site), site))
    }

    fn sites(&self, rows: Range<usize>) -> Range<usize> {
        let [start, end] =
            [rows.start, rows.end].map(|row| (row * self.lattice.columns).min(self.lattice.n));
        start..end
    }

    fn at(&self, id: usize, site: usize) -> Particle {
        let [vx, vy, ..] = philox4x32([id as u32, 0, SPEEDS, 0], [self.seed, 0]).map(unit_speed);
        Particle {
            x: self.lattice.x(site),
            y: self.lattice.y(site / self.lattice.columns),
            vx,
            vy,
            id: id as u32,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::general;
    use super::*;

    #[test]
    fn its_positions_are_those_of_the_official_scene() {
        for n in [1, 2, 3, 7, 100, 1000, 1023] {
            let counter = sites(&Scene::counter(n, 1).unwrap());
            let official = sites(&Scene::official(n, 1).unwrap());
            assert_eq!(counter, official, "n = {n}");
        }
    }

    /// Returns the bits of all positions, in order.
    fn sites(scene: &Scene) -> Vec<[u64; 2]> {
        let mut sites: Vec<_> =
            scene.particles().iter().map(|p| [p.y.to_bits(), p.x.to_bits()]).collect();
        sites.sort_unstable();
        sites
    }

    #[test]
    fn parts_make_the_whole() {
        let n = 1013;
        let scene = CounterParticles::new(n, 7).unwrap();
        let cuts = [0, 1, 9, 9, 31, scene.rows()];
        let mut parts: Vec<Particle> = Vec::new();
        for cut in cuts.windows(2) {
            let part: Vec<Particle> = scene.in_rows(cut[0]..cut[1]).collect();
            assert_eq!(part.len(), scene.count_in(cut[0]..cut[1]));
            let rows = cut[0]..cut[1];
            assert!(part.iter().all(|p| rows.clone().any(|row| scene.y(row) == p.y)));
            parts.extend(part);
        }
        parts.sort_by_key(|p| p.id);
        assert_eq!(parts, Scene::counter(n, 7).unwrap().particles());
    }

    #[test]
    fn speeds_are_spread_from_minus_one_to_one() {
        let scene = Scene::counter(20_000, 3).unwrap();
        let speeds: Vec<f64> = scene.particles().iter().flat_map(|p| [p.vx, p.vy]).collect();
        assert!(speeds.iter().all(|v| (-1.0..1.0).contains(v)));
        // The bounds are five standard errors of 40,000 numbers.
        let mean = speeds.iter().sum::<f64>() / 40_000.0;
        assert!(mean.abs() < 0.0145, "mean {mean}");
        let square = speeds.iter().map(|v| v * v).sum::<f64>() / 40_000.0;
        assert!((square - 1.0 / 3.0).abs() < 0.0075, "square {square}");
        let across: f64 = scene.particles().iter().map(|p| p.vx * p.vy).sum::<f64>() / 20_000.0;
        assert!(across.abs() < 0.012, "vx and vy go together: {across}");
    }

    /// A scene must be the same at any time and on every machine.
    #[test]
    fn the_scene_never_changes() {
        let scene = CounterParticles::new(1_000_000_000, 1).unwrap();
        for (id, line) in [
            (0, "151.577 205.777 -0.945096 -0.480396"),
            (999_999_999, "493.481 524.673 0.0482457 0.837474"),
        ] {
            let Particle { x, y, vx, vy, .. } = scene.particle(id);
            assert_eq!([x, y, vx, vy].map(general).join(" "), line);
        }
    }

    #[test]
    fn bad_scenes_are_refused() {
        for (n, seed, error) in [
            (0, 1, SceneError::Empty("particle")),
            (1 << 31, 1, SceneError::TooMany("particle", 1 << 31)),
            (10, 0, SceneError::SeedZero),
        ] {
            assert_eq!(CounterParticles::new(n, seed).unwrap_err(), error);
        }
    }
}
