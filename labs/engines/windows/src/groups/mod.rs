//! Groups of particles that may touch one another in a window, and their run through the window.
//!
//! [`Grouper`] makes groups from pairs, `slots` stores them, and `run` computes them. Groups of
//! two, three and four run side by side in vector registers (`together`).

mod arrangement;
mod grouper;
mod numbering;
mod run;
mod slots;
mod task;
mod together;
mod union;

pub(crate) use grouper::Grouper;
pub(crate) use slots::{Groups, Record};
pub(crate) use task::Task;

use common::soft::Particle;

/// The slot of a particle in free flight, which is in no group.
pub(crate) const FREE: u32 = u32::MAX;

/// Groups that were computed together, and their result.
#[derive(Default)]
pub(crate) struct Batch {
    pub(crate) groups: Groups,
    pub(crate) record: Record,
    /// The number of the batch's first slot.
    pub(crate) first: usize,
    /// Number of members that are in no earlier batch.
    pub(crate) new: usize,
    /// The greatest deviation of a member from its reference path.
    pub(crate) greatest_deviation: f64,
}

impl Batch {
    /// Returns the member in slot `p` at the end of the run. `id` is the member's id.
    pub(crate) fn end(&self, p: usize, id: u32) -> Particle {
        let Record { x, y, vx, vy, .. } = &self.record;
        Particle { x: x[p], y: y[p], vx: vx[p], vy: vy[p], id }
    }

    /// Records the slot and the deviation of each member.
    ///
    /// Both arrays have an element for each particle, beginning with particle `first`.
    pub(crate) fn note(
        &mut self,
        flag: u32,
        first: usize,
        slots: &mut [u32],
        deviation: &mut [f64],
    ) {
        let Self { groups, record, new, greatest_deviation, .. } = self;
        *new = 0;
        *greatest_deviation = 0.0;
        groups.for_each_member(|slot, i| {
            let noted = &mut slots[i as usize - first];
            *new += usize::from(*noted == FREE);
            *noted = flag + slot as u32;
            deviation[i as usize - first] = record.deviation[slot];
            *greatest_deviation = record.deviation[slot].max(*greatest_deviation);
        });
    }
}
