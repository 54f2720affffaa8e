//! Lists for ranks: one for each, or one behind the other in one buffer, as Gatherv and Scatterv want them.

use mpi::Count;

use crate::Wire;

/// Where each part begins when parts of these sizes stand one behind the other: of 2, 4, 1 at 0, 2,
/// 6. Counted in items, not in bytes.
pub fn displacements(counts: &[Count]) -> Vec<Count> {
    let mut next = 0;
    let mut begins = Vec::with_capacity(counts.len());
    for count in counts {
        begins.push(next);
        next += count;
    }
    begins
}

/// How many items there are in parts of these sizes.
pub fn total(counts: &[Count]) -> usize {
    counts.iter().map(|count| *count as usize).sum()
}

/// The parts of `all`, which have these sizes.
pub fn split(all: &[Wire], counts: &[Count]) -> Vec<Vec<Wire>> {
    let mut rest = all;
    let mut parts = Vec::with_capacity(counts.len());
    for count in counts {
        let (part, behind) = rest.split_at(*count as usize);
        parts.push(part.to_vec());
        rest = behind;
    }
    parts
}

/// The lists for `ranks` ranks, from particles that each have their rank, in the order of the particles.
pub fn by_rank(particles: impl IntoIterator<Item = (usize, Wire)>, ranks: usize) -> Vec<Vec<Wire>> {
    let mut lists = vec![Vec::new(); ranks];
    for (rank, wire) in particles {
        lists[rank].push(wire);
    }
    lists
}
