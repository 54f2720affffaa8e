//! Which batch computes a particle, and which pairs touched though no group computes them.

use common::soft::CUTOFF;
use neighbour_list::kernels::Pair;

use super::opening::{LATE, Window};
use crate::groups::{Batch, FREE};
use crate::{Rules, Span};

impl Window {
    /// The batch that computes a particle that is not free, and its slot there.
    #[inline]
    pub(crate) fn slot(&self, i: u32) -> Option<(&Batch, usize)> {
        let slot = self.slots[i as usize];
        if slot == FREE {
            return None;
        }
        if slot & LATE == 0 {
            let own = self.bands.partition_point(|band| band.particles.end <= i as usize);
            return Some((&self.bands[own].batch, slot as usize));
        }
        let slot = (slot & !LATE) as usize;
        let batch = &self.late[self.late.partition_point(|batch| batch.first <= slot) - 1];
        Some((batch, slot - batch.first))
    }

    /// Whether the two are a pair of one group.
    pub(crate) fn computes(&self, [i, k]: Pair) -> bool {
        self.slot(i).is_some_and(|(batch, p)| batch.groups.computes(&batch.groups.group(p), i, k))
    }

    /// Whether a pair that is computed nowhere was in contact at any step.
    pub(crate) fn touched<R: Rules>(&self, pair: Pair, span: &Span) -> bool {
        let slots = pair.map(|i| self.slot(i));
        let paths = pair.map(|i| span.path::<R>(&self.bodies.get(i as usize)));
        let blocks = slots.map(|slot| {
            slot.map(|(batch, p)| {
                let block = batch.groups.block(p);
                let member = p - block.start;
                (batch, block, member)
            })
        });
        for step in 1..span.steps {
            let time = f64::from(step) * span.dt;
            let mut off = [(0.0, 0.0); 2];
            for (off, block) in off.iter_mut().zip(&blocks) {
                if let Some((batch, block, member)) = block {
                    *off = batch.record.off(block, *member, step as usize);
                }
            }
            let [(ax, ay), (bx, by)] = off;
            let dx = paths[1].x + paths[1].wx * time + bx - paths[0].x - paths[0].wx * time - ax;
            let dy = paths[1].y + paths[1].wy * time + by - paths[0].y - paths[0].wy * time - ay;
            // The distances off are rounded to single precision.
            let lost = 2.4e-7 * (ax.abs() + ay.abs() + bx.abs() + by.abs());
            let near = CUTOFF + lost + span.rounding();
            if dx * dx + dy * dy <= near * near {
                return true;
            }
        }
        false
    }
}
