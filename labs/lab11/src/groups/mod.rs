//! Groups that are computed at the same time.

mod grouper;
mod run;
mod slots;
mod together;

pub(crate) use grouper::{Grouper, Task};
pub(crate) use run::all_pairs;
pub(crate) use slots::{Groups, LANES, Record};

use common::soft::Particle;
use solution10::Bodies;
use solution10::kernels::larger;
use solution10::list::{Fast, Pace};

/// Nobody runs the particle: it flies freely.
pub(crate) const FREE: u32 = u32::MAX;

/// Groups and what became of them.
#[derive(Default)]
pub(crate) struct Batch {
    pub(crate) groups: Groups,
    pub(crate) record: Record,
    /// The number of its first seat.
    pub(crate) first: usize,
    /// How many of its members are in no earlier batch.
    pub(crate) new: usize,
    /// How far the most bent of its members is off.
    pub(crate) most_bent: f64,
}

impl Batch {
    /// Where the member in seat `p` is at last, and with which id.
    pub(crate) fn end(&self, p: usize, id: u32) -> Particle {
        let Record { x, y, vx, vy, .. } = &self.record;
        Particle { x: x[p], y: y[p], vx: vx[p], vy: vy[p], id }
    }

    /// Notes the members that end faster than usual, or went further in `time` than they may.
    pub(crate) fn watch(&self, bodies: &Bodies, time: f64, pace: &Pace<'_>, fast: &mut Fast) {
        let Record { x, y, vx, vy, .. } = &self.record;
        self.groups.for_each_member(|p, i| {
            let (dx, dy) = (x[p] - bodies.x[i as usize], y[p] - bodies.y[i as usize]);
            let mean = (dx * dx + dy * dy) / (time * time);
            pace.judge(i, larger(vx[p] * vx[p] + vy[p] * vy[p], mean), fast);
        });
    }

    /// Writes down for each member where it sits and how far it was bent; both arrays are of all
    /// particles from number `first` on.
    pub(crate) fn note(&mut self, flag: u32, first: usize, slots: &mut [u32], bent: &mut [f32]) {
        let Self { groups, record, .. } = self;
        let (mut most, mut new) = (0.0, 0);
        groups.for_each_member(|seat, i| {
            let slot = &mut slots[i as usize - first];
            new += usize::from(*slot == FREE);
            *slot = flag + seat as u32;
            // Rounded up.
            bent[i as usize - first] = record.bent[seat] as f32 * (1.0 + 1e-6);
            most = record.bent[seat].max(most);
        });
        (self.most_bent, self.new) = (most, new);
    }
}
