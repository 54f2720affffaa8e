//! The particle.

use crate::Vec2;

/// A particle: its position, its velocity and its id.
///
/// Its acceleration is stored in a separate array, because it is valid for one step only. So a
/// program can read all positions while it writes accelerations.
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
    /// Number of the particle in the scene, 0 .. n. The number stays the same when a lab moves the
    /// particle in memory.
    pub id: u32,
}

impl Particle {
    /// Returns the vector from this particle to `other`.
    #[inline]
    pub fn to(&self, other: &Self) -> Vec2 {
        Vec2::new(other.x - self.x, other.y - self.y)
    }
}

/// Copies the particles with ids `first .. first + out.len()` to `out`, in id order.
///
/// `particles` may be in any order.
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
