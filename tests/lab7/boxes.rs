//! Questions about swept boxes and blocks of them: tasks 7.11 and 7.12.

use hard_discs::{Span, Window};
use lab7::{block_of, blocks_around, look_around, span};
use oracle::{Ask, Near, Random, beside, integers};

/// Asks for the swept boxes of fast and slow discs, in windows of any length.
pub(crate) fn spans(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..2000 {
        let count = 1 + random.size(4097);
        let part = Window::part(random.below(count), count);
        let window = [part, Window::STEP, Window { from: 0.25, to: 1.5 }][case % 3];
        let unit = random.magnitude(1e-12, 1e12);
        let x = unit * random.signed(1e-3, 1e3);
        let speed = unit * random.signed(1e-9, 1e3);
        let v = if case % 7 == 0 { 0.0 } else { speed };
        let reach = unit * random.magnitude(1e-6, 1e3);
        let question = format!(
            "x = {x:?}, v = {v:?}, λ from {} to {}, reach {reach:?}: low end and high end of the box",
            window.from, window.to
        );
        let found = || {
            let Span { low, high } = span(x, v, window, reach);
            vec![low, high]
        };
        ask.near(&question, found, || {
            let ends = [window.from, window.to.min(1.0)].map(|time| x + v * time);
            let scale = 1e-3 * (x.abs() + v.abs() + reach);
            let low = ends[0].min(ends[1]) - reach;
            let high = ends[0].max(ends[1]) + reach;
            [low, high].map(|right| Near { right, scale }).to_vec()
        });
    }
}

/// Draws an end of a box: on an edge between blocks, beside an edge, outside the square, or
/// anywhere.
fn end(random: &mut Random, side: f64) -> f64 {
    match random.below(5) {
        0 => beside(random.below(5) as f64 * 0.25 * side)[random.below(3)],
        1 => random.signed(1e-3, 10.0) * side,
        _ => random.between(0.0, side),
    }
}

/// Draws the extent of a box along one axis: at most `most` of the side long, or with arbitrary
/// ends.
fn extent(random: &mut Random, side: f64, most: f64) -> Span {
    let low = end(random, side);
    let other = low + most * side * random.between(0.0, 1.0);
    let high = if random.below(3) == 0 { end(random, side) } else { other };
    Span { low: low.min(high), high: low.max(high) }
}

/// Asks for the blocks of boxes inside blocks and across edges, and for the blocks around each
/// block.
pub(crate) fn blocks(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..6000 {
        // A power of two as the side makes quarters of the side exact.
        let side = random.magnitude(1e-12, 1e12).log2().round().exp2();
        let [x, y] = [(); 2].map(|()| extent(random, side, [0.01, 0.2, 0.6][case % 3]));
        let question = format!(
            "a box from x = {:?} to {:?} and from y = {:?} to {:?}, in a square of side {side:?}: its block",
            x.low, x.high, y.low, y.high
        );
        ask.exact(
            &question,
            || integers([block_of(x, y, side)]),
            || integers([smallest(x, y, side)]),
        );
    }
    for block in 0..21 {
        let found = || {
            let mut found = blocks_around(block);
            found.sort_unstable();
            integers(found)
        };
        let question = format!("block {block}: the blocks around it, in ascending order");
        ask.exact(&question, found, || integers(around(block)));
    }
}

/// Returns the smallest block that holds a box.
fn smallest(x: Span, y: Span, side: f64) -> usize {
    for (blocks, first) in [(4, 0), (2, 16)] {
        let [left, right, low, high] = [x.low, x.high, y.low, y.high]
            .map(|at| (1..blocks).filter(|&k| at >= k as f64 * (side / blocks as f64)).count());
        if left == right && low == high {
            return first + blocks * low + left;
        }
    }
    20
}

/// Returns the blocks around block `block`.
fn around(block: usize) -> Vec<usize> {
    match block {
        0..16 => vec![16 + 2 * (block / 4 / 2) + block % 4 / 2, 20],
        16..20 => vec![20],
        _ => vec![],
    }
}

/// Returns the pairs that the search tests, in ascending order, with the lower disc of each pair
/// first.
fn pairs_looked_at(blocks: &[Vec<u32>]) -> Vec<f64> {
    let mut pairs = Vec::new();
    for (block, discs) in blocks.iter().enumerate() {
        for (index, &disc) in discs.iter().enumerate() {
            look_around(blocks, block, index, |partners| {
                pairs.extend(partners.iter().map(|&other| [disc.min(other), disc.max(other)]));
            });
        }
    }
    pairs.sort_unstable();
    pairs.concat().into_iter().map(f64::from).collect()
}

/// Returns the pairs whose blocks are the same or neighbours.
fn pairs_that_may_meet(blocks: &[Vec<u32>]) -> Vec<f64> {
    let all = blocks.iter().enumerate();
    let all = all.flat_map(|(block, discs)| discs.iter().map(move |&disc| (disc, block)));
    let all: Vec<(u32, usize)> = all.collect();
    let mut pairs = Vec::new();
    for (k, &(a, p)) in all.iter().enumerate() {
        for &(b, q) in &all[..k] {
            if p == q || around(p).contains(&q) || around(q).contains(&p) {
                pairs.push([a.min(b), a.max(b)]);
            }
        }
    }
    pairs.sort_unstable();
    pairs.concat().into_iter().map(f64::from).collect()
}

/// Asks for the tested pairs of discs in any blocks, in all blocks of a level, or in one block.
/// Each pair that may meet is tested once.
pub(crate) fn looks_around(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..120 {
        let mut blocks = vec![Vec::new(); 21];
        let n = random.below(1 + case);
        let crowd = random.below(21);
        for k in 0..n {
            let block = [random.below(21), random.below(16), crowd, 16 + random.below(5)][case % 4];
            // The disc numbers are unordered and have gaps.
            blocks[block].push((k * 7919 % 4097 * 70_001) as u32);
        }
        let question = format!(
            "{n} discs in blocks {blocks:?}: the two discs of each tested pair, the lower disc first, with the pairs \
             in ascending order"
        );
        ask.exact(&question, || pairs_looked_at(&blocks), || pairs_that_may_meet(&blocks));
    }
    let question = "70,000 discs in the block that is the whole square: number of pairs tested";
    ask.exact(question, || integers([looks_in_one_block(70_000)]), || integers([69_999 * 35_000]));
}

fn looks_in_one_block(discs: u32) -> usize {
    let mut blocks = vec![Vec::new(); 21];
    blocks[20] = (0..discs).collect();
    let mut looks = 0;
    for index in 0..discs as usize {
        look_around(&blocks, 20, index, |partners| looks += partners.len());
    }
    looks
}
