//! The scenes of the contest and their exact final states.
//!
//! The kinds of scenes are public, but each scene is drawn from a seed. Computing the exact motion
//! of 100,000 particles would take minutes. So the exact motion is computed only for the particles
//! in a square, which is also drawn from the seed. The judge considers only the particles that the
//! edge of the square cannot have influenced.

use common::soft::{DT, Particle, Scene};

use crate::Random;
use crate::reference::{Fineness, exact};

/// Number of official steps after which the error is measured. Later, chaos would hide the method's
/// error.
pub const STEPS: u64 = 100;

/// Side of the square whose exact motion is computed.
const SQUARE: f64 = 1.2;

/// Distance from the edge of the square. No influence of the edge travels so far within [`STEPS`]
/// steps.
const MARGIN: f64 = 0.25;

/// Number of particles per fast particle in scenes of [`Kind::Fast`].
const FAST: usize = 100;

/// A kind of scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The official scene.
    Official,
    /// The official scene with many particles.
    Large,
    /// The official scene in a box of five times the side: hardly any particles meet.
    Thin,
    /// The official scene in a box of 0.65 times the side: more than twice as many particles meet.
    Crowd,
    /// The official scene with one particle in a hundred three times as fast.
    Fast,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Official, Self::Large, Self::Thin, Self::Crowd, Self::Fast];

    /// Returns the name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Official => "official",
            Self::Large => "large",
            Self::Thin => "thin gas",
            Self::Crowd => "crowd",
            Self::Fast => "few fast",
        }
    }

    /// Returns the number of particles in the contest.
    pub fn n(self) -> usize {
        match self {
            Self::Large => 100_000,
            Self::Official | Self::Thin => 10_000,
            Self::Crowd => 2000,
            Self::Fast => 3000,
        }
    }

    /// Makes the scene of `n` particles that this seed determines.
    ///
    /// # Panics
    /// If `n` or `seed` is 0, or `n` is more than a scene may have.
    pub fn scene(self, n: usize, seed: u32) -> Scene {
        let official = Scene::official(n as u64, seed).expect("n and seed are at least 1");
        let wider = match self {
            Self::Official | Self::Large | Self::Fast => 1.0,
            Self::Thin => 5.0,
            Self::Crowd => 0.65,
        };
        let size = wider * official.size();
        let mut particles: Vec<Particle> = official.particles().to_vec();
        for particle in &mut particles {
            particle.x = (wider * particle.x).min(size);
            particle.y = (wider * particle.y).min(size);
        }
        if self == Self::Fast {
            // The official scene has shuffled the ids, so these particles are anywhere.
            for particle in particles.iter_mut().step_by(FAST) {
                (particle.vx, particle.vy) = (3.0 * particle.vx, 3.0 * particle.vy);
            }
        }
        Scene::new(size, particles).expect("all particles are in the box")
    }

    /// Returns the exact states of particles after [`STEPS`] official steps of a scene of this
    /// kind: all particles, or the judged particles of a square that is drawn from `seed`. Each
    /// particle has its id in the scene.
    ///
    /// # Errors
    /// If the exact motion cannot be computed.
    pub fn exact_end(self, scene: &Scene, seed: u32) -> Result<Vec<Particle>, String> {
        // A wide window would link many particles in a crowd. Fast particles also link many
        // particles.
        let window = match self {
            Self::Official | Self::Large | Self::Thin => 2e-4,
            Self::Fast => 1e-4,
            Self::Crowd => 5e-5,
        };
        let fineness = Fineness { window, ..Fineness::FINE };
        let time = STEPS as f64 * DT;
        let has_square = matches!(self, Self::Official | Self::Large);
        if !has_square || scene.size() <= SQUARE {
            return exact(scene, time, fineness);
        }
        let square = Square::draw(scene.size(), seed);
        let (cut, ids) = square.cut(scene);
        let mut judged = exact(&cut, time, fineness)?;
        for particle in &mut judged {
            particle.x += square.left;
            particle.y += square.below;
            particle.id = ids[particle.id as usize];
        }
        judged.retain(|particle| square.is_inner(&scene.particles()[particle.id as usize]));
        Ok(judged)
    }
}

/// A square within the box.
struct Square {
    left: f64,
    below: f64,
}

impl Square {
    fn draw(size: f64, seed: u32) -> Self {
        let mut random = Random::new(seed.into());
        let mut draw = || random.between(0.0, size - SQUARE);
        Self { left: draw(), below: draw() }
    }

    /// Returns the scene within the square, and the ids of its particles in the whole scene.
    fn cut(&self, scene: &Scene) -> (Scene, Vec<u32>) {
        let mut particles = Vec::new();
        let mut ids = Vec::new();
        for &particle in scene.particles() {
            let (x, y) = (particle.x - self.left, particle.y - self.below);
            if (0.0..=SQUARE).contains(&x) && (0.0..=SQUARE).contains(&y) {
                particles.push(Particle { x, y, ..particle });
                ids.push(particle.id);
            }
        }
        (Scene::new(SQUARE, particles).expect("all particles are in the square"), ids)
    }

    /// Whether the edge of the square is too far away to influence a particle that starts here.
    fn is_inner(&self, particle: &Particle) -> bool {
        let inner = MARGIN..=SQUARE - MARGIN;
        inner.contains(&(particle.x - self.left)) && inner.contains(&(particle.y - self.below))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_has_the_motion_of_the_whole_scene() {
        let scene = Kind::Official.scene(3500, 7);
        let judged = Kind::Official.exact_end(&scene, 7).unwrap();
        let all = exact(&scene, STEPS as f64 * DT, Fineness::FINE).unwrap();
        assert!((500..3000).contains(&judged.len()), "{}", judged.len());
        for particle in judged {
            let off = particle.to(&all[particle.id as usize]).norm_squared().sqrt();
            assert!(off < 1e-9, "particle {} is {off:e} off", particle.id);
        }
    }

    #[test]
    fn each_kind_has_scenes_of_its_own() {
        for kind in Kind::ALL {
            let scene = kind.scene(500, 3);
            assert_eq!(scene, kind.scene(500, 3));
            assert_ne!(scene, kind.scene(500, 4));
        }
    }
}
