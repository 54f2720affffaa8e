//! The search for particles that could meet within a window.
//!
//! [`Listed`] is a list of pairs for several windows. `approach` selects the pairs of one window
//! from it, and [`Search::at_wall`] adds the pairs of particles that may reach a wall. The
//! distances are in [`Layout`].

mod approach;
mod layout;
mod listed;

use std::marker::PhantomData;

use common::soft::CUTOFF;
use neighbour_list::Bodies;
use neighbour_list::kernels::Pair;
use neighbour_list::list::{Block, Pairs};
use pulp::Arch;

use crate::rules::Rules;
use approach::Approach;
pub(crate) use layout::Layout;
pub(crate) use listed::Listed;

/// The result of a search.
#[derive(Default)]
pub(crate) struct Found {
    /// Pairs that are to be computed. A pair may occur more than once.
    pub(crate) close: Vec<Pair>,
    /// Pairs that come nearly as close as the pairs in `close`. These pairs are checked after the
    /// window.
    pub(crate) watched: Vec<Pair>,
    /// Number of pairs that were tested.
    pub(crate) tested: u64,
}

/// The particles of a window, and a list of the pairs that may come near each other in it.
#[derive(Clone, Copy)]
pub(crate) struct Search<'a> {
    pub(crate) bodies: &'a Bodies,
    pub(crate) listed: &'a Listed,
    pub(crate) layout: &'a Layout,
}

impl Search<'_> {
    /// Finds the listed pairs of a block whose free flights come near each other.
    ///
    /// The result may lack pairs with a particle that may reach a wall.
    pub(crate) fn flights<R: Rules>(&self, block: &Block, found: &mut Found) {
        let Self { bodies, layout, .. } = *self;
        let Pairs { inside, across, .. } = block.pairs();
        Arch::new().dispatch(Approach::<R> {
            pairs: [inside, across],
            bodies,
            layout,
            found,
            rules: PhantomData,
        });
    }

    /// Finds all pairs of particle `i`, which may reach a wall.
    pub(crate) fn at_wall<R: Rules>(&self, i: u32, found: &mut Found) {
        let slack = self.layout.slack();
        let Found { close, tested, .. } = found;
        *tested += self.around::<R>(i, slack, |_| slack, |k| close.push([i.min(k), i.max(k)]));
    }

    /// Calls `visit` with every particle k that may touch particle `i` in the window.
    ///
    /// The deviations of both particles from their reference paths add up to at most `slack(k)`,
    /// which never exceeds `most`. Returns the number of pairs that were tested.
    pub(crate) fn around<R: Rules>(
        &self,
        i: u32,
        most: f64,
        slack: impl Fn(usize) -> f64,
        mut visit: impl FnMut(u32),
    ) -> u64 {
        let Self { bodies, listed, layout: Layout { span, reach, .. } } = *self;
        let Some(cells) = &listed.list.cells else { return 0 };
        let path = span.path::<R>(&bodies.get(i as usize));
        let time = span.forces();
        // The cells were computed from the positions at which the particles were listed.
        let pad = CUTOFF + path.spread + most + span.rounding() + reach + listed.moved;
        let far = CUTOFF + path.spread + most + span.rounding() + 2.0 * reach;
        let dx = path.wx * time;
        let dy = path.wy * time;
        let mut rows = cells.rows_of(&[
            path.x + dx.min(0.0) - pad,
            path.x + dx.max(0.0) + pad,
            path.y + dy.min(0.0) - pad,
            path.y + dy.max(0.0) + pad,
        ]);
        let mut tested = 0;
        while let Some(range) = rows.next(cells) {
            tested += range.len() as u64;
            for k in range {
                let dx = bodies.x[k] - path.x;
                let dy = bodies.y[k] - path.y;
                if dx * dx + dy * dy > far * far {
                    continue;
                }
                let other = span.path::<R>(&bodies.get(k));
                if path.may_touch::<R>(&other, time, slack(k) + span.rounding()) && k != i as usize
                {
                    visit(k as u32);
                }
            }
        }
        tested
    }
}
