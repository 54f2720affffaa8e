//! Whether two particles that nobody computes as a pair touched.

use common::soft::CUTOFF;

use crate::layout::Layout;
use crate::search::Pair;
use crate::window::Window;

impl Window {
    /// Whether a pair that is computed nowhere was in contact at any step.
    pub(crate) fn touched(&self, pair: Pair, layout: &Layout) -> bool {
        let span = &layout.span;
        let seats = pair.map(|i| self.seat(i));
        let paths = pair.map(|i| span.path(&self.bodies.get(i as usize)));
        let blocks = seats.map(|seat| {
            seat.map(|(batch, p)| {
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
