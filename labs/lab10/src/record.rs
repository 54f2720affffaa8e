//! What running a group leaves behind.

/// Where the members of groups are after some steps, and how far they were off their reference
/// paths on the way.
///
/// Members stand in blocks; a block is what runs together: sixteen couples, triples or quadruples,
/// or one larger group.
#[derive(Clone, Default)]
pub(crate) struct Record {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) vx: Vec<f64>,
    pub(crate) vy: Vec<f64>,
    /// The furthest off, beyond the path's own spread.
    pub(crate) bent: Vec<f64>,
    /// How far off after each step but the last: block by block, in it step by step, in it member
    /// by member.
    off_x: Vec<f32>,
    off_y: Vec<f32>,
    steps: usize,
}

/// The part of a [`Record`] that one block writes.
pub(crate) struct Slice<'a> {
    pub(crate) x: &'a mut [f64],
    pub(crate) y: &'a mut [f64],
    pub(crate) vx: &'a mut [f64],
    pub(crate) vy: &'a mut [f64],
    pub(crate) bent: &'a mut [f64],
    pub(crate) off_x: &'a mut [f32],
    pub(crate) off_y: &'a mut [f32],
}

impl Record {
    /// Makes room for `n` members and `steps` steps.
    pub(crate) fn resize(&mut self, n: usize, steps: u32) {
        for array in [&mut self.x, &mut self.y, &mut self.vx, &mut self.vy, &mut self.bent] {
            array.resize(n, 0.0);
        }
        self.steps = steps.saturating_sub(1) as usize;
        for array in [&mut self.off_x, &mut self.off_y] {
            array.resize(n * self.steps, 0.0);
        }
    }

    /// The block of `width` members from `first` on.
    pub(crate) fn block(&mut self, first: usize, width: usize) -> Slice<'_> {
        let own = first..first + width;
        let offs = first * self.steps..(first + width) * self.steps;
        Slice {
            x: &mut self.x[own.clone()],
            y: &mut self.y[own.clone()],
            vx: &mut self.vx[own.clone()],
            vy: &mut self.vy[own.clone()],
            bent: &mut self.bent[own],
            off_x: &mut self.off_x[offs.clone()],
            off_y: &mut self.off_y[offs],
        }
    }

    /// How far the `member`-th of a block was off its reference path after `step` steps, at least
    /// one and not all of them.
    #[inline]
    pub(crate) fn off(
        &self,
        block: &std::ops::Range<usize>,
        member: usize,
        step: usize,
    ) -> (f64, f64) {
        let place = block.start * self.steps + (step - 1) * block.len() + member;
        (f64::from(self.off_x[place]), f64::from(self.off_y[place]))
    }
}
