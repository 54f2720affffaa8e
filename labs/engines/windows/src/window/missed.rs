//! Finds the batch that computes a particle, and tests whether a pair touched without being
//! computed.

use common::soft::CUTOFF;
use neighbour_list::kernels::Pair;

use super::opening::{LATE, Window};
use crate::groups::{Batch, FREE};
use crate::rules::Rules;
use crate::span::Span;

impl Window {
    /// Returns the batch that computes a particle, and its slot there; `None` if the particle flies
    /// freely.
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

    /// Whether a group computes the pair.
    pub(crate) fn computes(&self, [i, k]: Pair) -> bool {
        self.slot(i).is_some_and(|(batch, p)| batch.groups.group(p).computes(i, k))
    }

    /// Whether a pair that no group computes was in contact after any step.
    pub(crate) fn touched<R: Rules>(&self, pair: Pair, span: &Span) -> bool {
        let [a, b] = pair.map(|i| span.path::<R>(&self.bodies.get(i as usize)));
        let blocks = pair.map(|i| {
            let (batch, p) = self.slot(i)?;
            Some((batch, batch.groups.group(p).block, p))
        });
        (1..span.steps).any(|step| {
            let time = f64::from(step) * span.dt;
            let off = blocks.each_ref().map(|block| match block {
                Some((batch, block, p)) => batch.record.off(block, *p, step as usize),
                None => [0.0; 2],
            });
            let [[ax, ay], [bx, by]] = off;
            let dx = b.x + b.wx * time + bx - a.x - a.wx * time - ax;
            let dy = b.y + b.wy * time + by - a.y - a.wy * time - ay;
            // The recorded distances are rounded to single precision.
            let lost = 2.4e-7 * off.as_flattened().iter().map(|off| off.abs()).sum::<f64>();
            let near = CUTOFF + lost + span.rounding();
            dx * dx + dy * dy <= near * near
        })
    }
}
