//! Loops that the threads of a rank share: forces of the interior, and moves.
//!
//! The first thread alone handles ghosts and messages. It also sorts alone, because the sort writes
//! to all parts of the array. Lab 3 shows the cost of a shared sort.

use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};
use solution1::advance;
use solution2::{Gather, Grid, SortedBins};
use workers::Workers;

/// Sums the forces on the particles of `rows`. These rows need no ghosts.
pub(crate) fn sum_rows<O: Observer>(
    own: &SortedBins,
    rows: Range<usize>,
    accelerations: &mut [Vec2],
    workers: &Workers,
) -> O {
    let chunk = rows.len().div_ceil(workers.count()).max(1);
    let mut rest = accelerations;
    let mut parts = Vec::new();
    for start in rows.clone().step_by(chunk) {
        let rows = start..(start + chunk).min(rows.end);
        let (part, others) = rest.split_at_mut(own.indices(rows.clone()).len());
        parts.push((rows, part));
        rest = others;
    }
    let mut all = O::default();
    let seen = workers.map(parts, |(rows, part)| {
        let mut observer = O::default();
        own.gather_rows(rows, part, &mut Gather::default(), &mut observer);
        observer
    });
    seen.iter().for_each(|observer| all.merge(observer));
    all
}

/// Moves `particles`. Returns the indices of the particles that left the rows `block`, in ascending
/// order.
pub(crate) fn move_all(
    particles: &mut [Particle],
    accelerations: &[Vec2],
    grid: &Grid,
    block: &Range<usize>,
    workers: &Workers,
) -> Vec<usize> {
    let chunk = particles.len().div_ceil(workers.count()).max(1);
    let parts = particles.chunks_mut(chunk).zip(accelerations.chunks(chunk));
    let indices = workers.map(
        parts.zip((0..).step_by(chunk)).collect(),
        |((particles, accelerations), first): ((&mut [Particle], &[Vec2]), usize)| {
            let mut indices = Vec::new();
            for (index, (particle, a)) in (first..).zip(particles.iter_mut().zip(accelerations)) {
                advance(particle, *a, grid.size());
                if !block.contains(&grid.row(particle.y)) {
                    indices.push(index);
                }
            }
            indices
        },
    );
    indices.concat()
}
