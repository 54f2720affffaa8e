//! The counter scene: any particle computed from its number alone.
//!
//! The official generator hands out its particles one after the other, and must remember the whole
//! shuffle meanwhile. So every process of a program that wants a part of the scene must replay all
//! of it, in memory that grows with the scene. Here nothing is remembered. The scene obeys the same
//! law: the same sites, each taken once, in shuffled order, with speeds drawn from -1 to 1. Only
//! the random numbers differ.

use std::ops::Range;

use super::lattice::Lattice;
use super::official::unit_speed;
use super::philox::philox4x32;
use super::shuffle::Shuffle;
use super::{Particle, Scene, SceneError};
use crate::room::room_for;

/// Which words of the generator are speeds; the shuffle takes those of stream 0.
const SPEEDS: u32 = 1;

/// The particles of a counter scene, each of which can be had without the rest.
///
/// Knows n and a seed and nothing else. Particles can be asked for by id, and by where they stand:
/// row by row of the lattice that they start on. So a process that has a part of the box makes the
/// particles of its part, in time and memory that grow with the part.
#[derive(Clone, Copy, Debug)]
pub struct CounterParticles {
    lattice: Lattice,
    shuffle: Shuffle,
    seed: u32,
}

impl Scene {
    /// The counter scene of `n` particles.
    ///
    /// # Errors
    /// As [`Scene::official`].
    pub fn counter(n: u64, seed: u32) -> Result<Self, SceneError> {
        let scene = CounterParticles::new(n, seed)?;
        let mut particles = room_for(scene.count()).ok_or(SceneError::Memory("particle", n))?;
        particles.extend((0..scene.count()).map(|id| scene.particle(id)));
        Self::new(scene.size(), particles)
    }
}

impl CounterParticles {
    /// The scene of `n` particles.
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

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.lattice.n
    }

    /// Side of the box.
    pub fn size(&self) -> f64 {
        self.lattice.size
    }

    /// Particle `id`, 0 .. [`count`](Self::count).
    pub fn particle(&self, id: usize) -> Particle {
        self.at(id, self.shuffle.forward(id))
    }

    /// Number of rows that the particles stand in, nearly √n.
    pub fn rows(&self) -> usize {
        self.lattice.rows
    }

    /// Where along y all particles of `row` stand. It grows with the row.
    pub fn y(&self, row: usize) -> f64 {
        self.lattice.y(row)
    }

    /// How many particles stand in `rows`.
    pub fn count_in(&self, rows: Range<usize>) -> usize {
        self.sites(rows).len()
    }

    /// The particles that stand in `rows`, in the order of their sites.
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

    /// The bits of all positions, in order.
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
        // Five standard errors of 40,000 draws.
        let mean = speeds.iter().sum::<f64>() / 40_000.0;
        assert!(mean.abs() < 0.0145, "mean {mean}");
        let square = speeds.iter().map(|v| v * v).sum::<f64>() / 40_000.0;
        assert!((square - 1.0 / 3.0).abs() < 0.0075, "square {square}");
        let across: f64 = scene.particles().iter().map(|p| p.vx * p.vy).sum::<f64>() / 20_000.0;
        assert!(across.abs() < 0.012, "vx and vy go together: {across}");
    }

    /// A scene must be the same tomorrow and on every machine.
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
