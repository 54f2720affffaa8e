//! The particle.

use crate::Vec2;

/// A particle: its id, where it is, how it moves.
///
/// Its acceleration is not part of it: that lives for one step only, in an array of its own, so
/// that a program can read all positions while it writes accelerations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Particle {
    /// Position along x, in 0 ..= size.
    pub x: f64,
    /// Position along y, in 0 ..= size.
    pub y: f64,
    /// Velocity along x.
    pub vx: f64,
    /// Velocity along y.
    pub vy: f64,
    /// Its number in the scene, 0 .. n. It keeps it wherever a lab moves it in memory.
    pub id: u32,
}

impl Particle {
    /// The vector from this particle to `other`.
    #[inline]
    pub fn to(&self, other: &Self) -> Vec2 {
        Vec2::new(other.x - self.x, other.y - self.y)
    }
}

/// Copies the particles with ids `first .. first + out.len()` into `out`, in id order, from
/// wherever they stand in `particles`.
pub fn read_by_id<'a>(
    particles: impl IntoIterator<Item = &'a Particle>,
    first: usize,
    out: &mut [Particle],
) {
    for particle in particles {
        let index = (particle.id as usize).checked_sub(first);
        if let Some(slot) = index.and_then(|index| out.get_mut(index)) {
            *slot = *particle;
        }
    }
}
