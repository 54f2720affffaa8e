//! Lists for ranks: a list for each rank, or all lists one after another in a buffer, as Gatherv and
//! Scatterv need them.

use mpi::Count;

use crate::Wire;

/// Returns the beginning of each part of a buffer, counted in items: parts of 2, 4 and 1 items begin at
/// 0, 2 and 6.
pub fn displacements(counts: &[Count]) -> Vec<Count> {
    let mut next = 0;
    let mut begins = Vec::with_capacity(counts.len());
    for count in counts {
        begins.push(next);
        next += count;
    }
    begins
}

/// Returns the number of items in parts of these sizes.
pub fn total(counts: &[Count]) -> usize {
    counts.iter().map(|count| *count as usize).sum()
}

/// Returns the parts of `all`, which have these sizes.
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

/// Distributes particles, each listed with its rank, to a list for each of `ranks` ranks. Lists keep
/// the order of the particles.
pub fn by_rank(particles: impl IntoIterator<Item = (usize, Wire)>, ranks: usize) -> Vec<Vec<Wire>> {
    let mut lists = vec![Vec::new(); ranks];
    for (rank, wire) in particles {
        lists[rank].push(wire);
    }
    lists
}
