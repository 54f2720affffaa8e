//! Groups that are computed at the same time.

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

/// The slot of a particle that flies freely.
pub(crate) const FREE: u32 = u32::MAX;

/// Groups and what became of them.
#[derive(Default)]
pub(crate) struct Batch {
    pub(crate) groups: Groups,
    pub(crate) record: Record,
    /// The number of its first slot.
    pub(crate) first: usize,
    /// How many of its members are in no earlier batch.
    pub(crate) new: usize,
    /// The greatest deviation of its members.
    pub(crate) greatest_deviation: f64,
}

impl Batch {
    /// Where the member in slot `p` is at last, and with which id.
    pub(crate) fn end(&self, p: usize, id: u32) -> Particle {
        let Record { x, y, vx, vy, .. } = &self.record;
        Particle { x: x[p], y: y[p], vx: vx[p], vy: vy[p], id }
    }

    /// Writes down the slot of each member and its deviation; both arrays are of all
    /// particles from number `first` on.
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
