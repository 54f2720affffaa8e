//! Tasks 6.1 and 6.2: blocks of rows, and which ranks are neighbours.

use halo::Cuts;

/// The ranks that have the row before and the row after the block of `rank`, in this order.
///
/// With a block of rows a..b those rows are a − 1 and b, and [`owner`](Cuts::owner) tells which
/// rank has them. Beyond a wall there is no row, so `None` stands there. A rank whose block is
/// empty has no neighbours and is no rank's neighbour: `owner` passes over it, and the adjacent
/// row belongs to a rank further on.
///
/// Book: chapter 6, *Neighbours*.
pub fn neighbours(cuts: &Cuts, rank: usize) -> [Option<usize>; 2] {
    let block = cuts.block(rank);
    let rows = cuts.rows();
    // task 6.2: the neighbours of a rank
    if block.is_empty() {
        return [None, None];
    }
    let before = block.start.checked_sub(1);
    let after = (block.end < rows).then_some(block.end);
    [before, after].map(|row| row.map(|row| cuts.owner(row)))
    // end 6.2
}

/// Cuts rows that hold `counts[row]` particles each into `ranks` blocks of nearly equal numbers of
/// particles. Both numbers are at least 1.
///
/// Of all N particles, k · N / `ranks` (an integer division, rounded down) should lie in the rows
/// before block k. But a cut can only be made between rows. So block k starts at the first row
/// before which at least that many lie, and no block has more than N / `ranks` + 1 particles and
/// those of one row. Block 0 starts at row 0 and the last block ends with the last row, so every
/// row belongs to a rank, also where there are no particles at all.
///
/// Return `ranks` + 1 starts, ascending.
///
/// Book: chapter 6, *Balance*.
pub fn balanced(counts: &[u64], ranks: usize) -> Cuts {
    // task 6.1: blocks of nearly equal numbers of particles
    let all: u64 = counts.iter().sum();
    let mut starts = vec![0];
    let (mut row, mut before) = (0, 0);
    for rank in 1..ranks as u64 {
        let share = (u128::from(rank) * u128::from(all) / ranks as u128) as u64;
        while before < share {
            before += counts[row];
            row += 1;
        }
        starts.push(row);
    }
    starts.push(counts.len());
    Cuts { starts }
    // end 6.1
}
