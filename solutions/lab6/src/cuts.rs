//! Tasks 6.1 and 6.2: blocks of rows, and neighbouring ranks.

use halo::Cuts;

/// Cuts the rows of bins into `ranks` blocks with nearly equal numbers of particles.
///
/// - `counts[row]` is the number of particles in a row. There is at least one row and one rank.
/// - Of all N particles, k · N / `ranks` (rounded down) should be before block k. But a cut must be
///   between two rows. So block k starts at the first row that has at least that many particles
///   before it. No block then has more than N / `ranks` + 1 particles, plus the particles of one
///   row. A count may be any `u64`, so compute k · N as a `u128`.
/// - Block 0 starts at row 0, and the last block ends with the last row, so every row belongs to a
///   rank, even in an empty box.
///
/// Return `Cuts { starts }` with the `ranks` + 1 starts in ascending order.
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

/// Returns the ranks that have the row before and the row after the block of `rank`, in this order.
///
/// - For a block of rows a..b, these are rows a − 1 and b. [`owner`](Cuts::owner) returns the rank
///   that has a row.
/// - Beyond a wall there is no row: return `None` on that side.
/// - A rank with an empty block has no neighbours, and is not a neighbour of any rank. `owner`
///   skips empty blocks, because the adjacent row belongs to a rank further on.
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
