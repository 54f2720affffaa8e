//! Questions about blocks of rows: their starts, the neighbouring ranks, and the rows that need no
//! ghosts.

use lab6::{Cuts, balanced, interior_rows, neighbours};
use oracle::{Ask, Random, integers, within};

/// Asks for the starts of blocks. The rows have few particles, or more than 32 bits can count.
/// Their sum fits into 64 bits.
pub(crate) fn starts_of_blocks(random: &mut Random, ask: &mut impl Ask) {
    // Equal shares of equal rows. A share that is computed in floating point may be rounded below a
    // whole number.
    for ranks in 1..130 {
        let counts = vec![1; ranks];
        let question = format!(
            "{ranks} rows with one particle each, on {ranks} ranks: row at which each block starts, then the number \
             of rows"
        );
        let found = || integers(balanced(&counts, ranks).starts);
        ask.exact(&question, found, || integers(0..=ranks));
    }
    for case in 0..150 {
        let most = if case % 15 == 14 { 4097 } else { 40 };
        let rows = 1 + random.size(most);
        let ranks = 1 + random.size(most);
        // The total barely fits into 64 bits, fits easily, or is smaller than the number of ranks.
        let few = match case % 3 {
            0 => 2 + rows.ilog2() as usize + random.below(4),
            1 => 2 + rows.ilog2() as usize + random.below(50),
            _ => 61 + random.below(3),
        };
        let gap = random.below(4);
        let count = |_| if random.below(4) < gap { 0 } else { random.bits() >> few };
        let counts: Vec<u64> = (0..rows).map(count).collect();
        let shown = &counts[..rows.min(40)];
        let question = format!(
            "{rows} rows on {ranks} ranks, with {shown:?} particles in the first rows: row at which each block \
             starts, then the number of rows"
        );
        ask.exact(
            &question,
            || integers(balanced(&counts, ranks).starts),
            || integers(starts(&counts, ranks)),
        );
    }
}

/// Asks for a million blocks. A program that goes up from row 0 for every rank does not finish.
pub(crate) fn a_million_blocks(_: &mut Random, ask: &mut impl Ask) {
    ask.exact(
        "1,000,000 rows with one particle each, on 1,000,000 ranks: (1) number of starts, (2) number of blocks that \
         start at the row with the block's number",
        || within("6.1", 60, blocks_of_a_row),
        || vec![1_000_001.0; 2],
    );
}

fn blocks_of_a_row() -> Vec<f64> {
    let starts = balanced(&vec![1; 1_000_000], 1_000_000).starts;
    let right = starts.iter().enumerate().filter(|(block, start)| block == *start).count();
    vec![starts.len() as f64, right as f64]
}

/// Returns the correct starts of blocks.
pub(crate) fn starts(counts: &[u64], ranks: usize) -> Vec<usize> {
    let all: u128 = counts.iter().map(|count| u128::from(*count)).sum();
    let mut starts = vec![0];
    let mut before = 0;
    let mut row = 0;
    for rank in 1..ranks {
        while before < rank as u128 * all / ranks as u128 {
            before += u128::from(counts[row]);
            row += 1;
        }
        starts.push(row);
    }
    starts.push(counts.len());
    starts
}

/// Draws blocks of rows for `ranks` ranks, many of them empty.
fn some_cuts(random: &mut Random, ranks: usize, rows: usize) -> Cuts {
    let mut starts: Vec<usize> = (1..ranks).map(|_| random.below(rows + 1)).collect();
    starts.extend([0, rows]);
    starts.sort_unstable();
    Cuts { starts }
}

/// Returns the rank that has a row. Its block is the only nonempty block that contains the row.
pub(crate) fn owner(cuts: &Cuts, row: usize) -> usize {
    (0..cuts.starts.len() - 1).find(|rank| cuts.block(*rank).contains(&row)).unwrap_or(0)
}

/// Returns the ranks before and after a rank.
fn beside(cuts: &Cuts, rank: usize) -> [Option<usize>; 2] {
    let block = cuts.block(rank);
    if block.is_empty() {
        return [None, None];
    }
    let after = (block.end < cuts.rows()).then(|| owner(cuts, block.end));
    [block.start.checked_sub(1).map(|row| owner(cuts, row)), after]
}

/// Asks for the rank before and the rank after a rank, where they exist.
pub(crate) fn neighbours_of_ranks(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..200 {
        let is_large = case % 10 == 9;
        let rows = 1 + random.size(if is_large { 70_000 } else { 10 });
        let ranks = 1 + random.size(if is_large { 300 } else { 7 });
        let cuts = some_cuts(random, ranks, rows);
        // The highest ranks are asked too, for any number of ranks.
        for rank in (0..ranks).rev().take(8) {
            let shown = &cuts.starts[ranks.saturating_sub(8)..];
            let question = format!(
                "rank {rank} of {ranks}. The blocks of the last ranks start at the rows {shown:?}, in which the last \
                 number is the number of rows: (1) rank before, (2) rank after, -1 if there is no such rank"
            );
            let found = || numbers(neighbours(&cuts, rank));
            ask.exact(&question, found, || numbers(beside(&cuts, rank)));
        }
    }
}

/// Returns the ranks as numbers, -1 for a missing rank.
fn numbers(ranks: [Option<usize>; 2]) -> Vec<f64> {
    ranks.map(|rank| rank.map_or(-1.0, |rank| rank as f64)).to_vec()
}

/// Asks for the rows of any block of few rows whose neighbouring rows are all in the block.
pub(crate) fn interiors(_: &mut Random, ask: &mut impl Ask) {
    for rows in 1..9 {
        for start in 0..=rows {
            for end in start..=rows {
                let question = format!(
                    "block {start}..{end} of {rows} rows: start and end of its interior. If the block has no interior \
                     row, any empty range within the block is right"
                );
                let found = || {
                    let interior = interior_rows(&(start..end), rows);
                    integers([interior.start, interior.end])
                };
                ask.judge(&question, found, |found| is_interior(found, start, end, rows));
            }
        }
    }
}

fn is_interior(found: &[f64], start: usize, end: usize, rows: usize) -> Result<(), String> {
    let &[first, last] = found else { return Err("the answer is not a range".into()) };
    if !(start as f64 <= first && first <= last && last <= end as f64) {
        return Err(format!("{first}..{last} is not a range within the block"));
    }
    // Rows beyond the walls do not matter.
    let is_near = |row: usize| row >= rows || (start..end).contains(&row);
    let interior =
        (start..end).filter(|&row| is_near(row + 1) && row.checked_sub(1).is_none_or(is_near));
    let right: Vec<usize> = interior.collect();
    let within: Vec<usize> = (first as usize..last as usize).collect();
    if within == right {
        return Ok(());
    }
    Err(format!(
        "the range {first}..{last} contains the rows {within:?}, but the interior contains the rows {right:?}"
    ))
}
