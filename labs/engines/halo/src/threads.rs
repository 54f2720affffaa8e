//! What the threads of a rank share: forces of the interior, and moves.
//!
//! Ghosts and messages are the first thread's alone. So is the sort: it writes all over the
//! array, and lab 3 shows what it takes to share that.

use std::ops::Range;
use std::thread;

use common::Vec2;
use common::soft::{Observer, Particle};
use solution1::advance;
use solution2::{Gather, Grid, SortedBins};

/// Sums the forces on the particles of `rows`, which need no ghosts, on `threads` threads.
pub(crate) fn sum_rows<O: Observer>(
    own: &SortedBins,
    rows: Range<usize>,
    accelerations: &mut [Vec2],
    threads: usize,
) -> O {
    let chunk = rows.len().div_ceil(threads).max(1);
    let mut rest = accelerations;
    let mut parts = Vec::new();
    for start in rows.clone().step_by(chunk) {
        let rows = start..(start + chunk).min(rows.end);
        let (part, others) = rest.split_at_mut(own.indices(rows.clone()).len());
        parts.push((rows, part));
        rest = others;
    }
    let mut all = O::default();
    let seen = side_by_side(parts, |(rows, part)| {
        let mut observer = O::default();
        own.gather_rows(rows, part, &mut Gather::default(), &mut observer);
        observer
    });
    seen.iter().for_each(|observer| all.merge(observer));
    all
}

/// Moves `particles` on `threads` threads. Returns the indices of those that left the rows `block`,
/// in ascending order.
pub(crate) fn move_all(
    particles: &mut [Particle],
    accelerations: &[Vec2],
    grid: &Grid,
    block: &Range<usize>,
    threads: usize,
) -> Vec<usize> {
    let chunk = particles.len().div_ceil(threads).max(1);
    let parts = particles.chunks_mut(chunk).zip(accelerations.chunks(chunk)).enumerate();
    let indices = side_by_side(parts.collect(), |(number, (particles, accelerations))| {
        let mut indices = Vec::new();
        for (index, (particle, a)) in particles.iter_mut().zip(accelerations).enumerate() {
            advance(particle, *a, grid.size());
            if !block.contains(&grid.row(particle.y)) {
                indices.push(number * chunk + index);
            }
        }
        indices
    });
    indices.concat()
}

/// Does `work` on each of the parts, every one on a thread of its own and the last on this one.
/// Returns the results in the order of the parts.
fn side_by_side<P: Send, R: Send>(mut parts: Vec<P>, work: impl Fn(P) -> R + Sync) -> Vec<R> {
    let work = &work;
    thread::scope(|scope| {
        let last = parts.pop();
        let others: Vec<_> =
            parts.into_iter().map(|part| scope.spawn(move || work(part))).collect();
        let last = last.map(work);
        let join = |other: thread::ScopedJoinHandle<'_, R>| {
            other.join().expect("a panic ends the whole job before this")
        };
        let mut results: Vec<R> = others.into_iter().map(join).collect();
        results.extend(last);
        results
    })
}
