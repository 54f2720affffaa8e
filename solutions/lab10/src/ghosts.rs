//! Copies of the particles that the next block begins with.

use crate::filter::Places;

/// Where the first particles behind a block stood before anybody moved.
///
/// The last pieces of a block feel them, perhaps when the next block has moved already.
#[derive(Default)]
pub(crate) struct Ghosts {
    x: Vec<f64>,
    y: Vec<f64>,
    joined_x: Vec<f64>,
    joined_y: Vec<f64>,
}

impl Ghosts {
    /// Copies the places of particles that stand behind the block.
    pub(crate) fn copy(&mut self, x: &[f64], y: &[f64]) {
        for (to, from) in [(&mut self.x, x), (&mut self.y, y)] {
            to.clear();
            to.extend_from_slice(from);
        }
    }

    /// The places of the block's last particles, which begin with particle `first`, and behind
    /// them the copies.
    #[inline(always)]
    pub(crate) fn behind<'a>(&'a mut self, x: &[f64], y: &[f64], first: usize) -> Places<'a> {
        let Self { x: ghosts_x, y: ghosts_y, joined_x, joined_y } = self;
        for (to, own, ghosts) in [(&mut *joined_x, x, &*ghosts_x), (&mut *joined_y, y, &*ghosts_y)]
        {
            to.clear();
            to.extend_from_slice(own);
            to.extend_from_slice(ghosts);
        }
        Places { x: joined_x, y: joined_y, first }
    }
}
