//! Tasks 7.13: the report's grid of three levels.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use common::hard::Disc;

use crate::{
    Find, Found, Schedule, Span, Square, Survey, Team, Window, Workers, pair_hit, reach, span,
};

/// Blocks of all levels: 4 × 4 small ones, numbers 0 to 15; 2 × 2 medium ones, 16 to 19; the
/// whole square, 20.
pub const BLOCKS: usize = 21;

/// The smallest block of a square of side `side` that a swept box fits into.
///
/// Small blocks are numbered 4 row + column, medium ones 16 + 2 row + column, rows from below.
/// A box reaches into a block if an edge of it lies inside; what lies beyond the square counts
/// to the outermost blocks.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn block_of(x: Span, y: Span, side: f64) -> usize {
    todo!("task 7.13: the block of a box")
}

/// The blocks of coarser levels that overlap block number `block`, which are those around it: a
/// small block lies in a medium one and in the whole square.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn blocks_around(block: usize) -> Vec<usize> {
    todo!("task 7.13b: the blocks around a block")
}

/// Every disc is in the smallest block that its box of this step fits into. It can only meet the
/// discs of the same block and of the blocks around.
pub struct Grid {
    workers: Workers,
    chunk: usize,
    blocks: Vec<Vec<u32>>,
}

impl Grid {
    /// A grid whose discs are dealt out to `workers` from a queue, `chunk` discs at a time.
    pub fn new(workers: Workers, chunk: usize) -> Self {
        Self { workers, chunk, blocks: vec![Vec::new(); BLOCKS] }
    }

    fn fill(&mut self, discs: &[Disc], square: Square, window: Window) {
        let reach = reach(square, Survey::of(discs, square).fastest);
        self.blocks.iter_mut().for_each(Vec::clear);
        for (number, disc) in discs.iter().enumerate() {
            let (x, y) =
                (span(disc.x, disc.vx, window, reach), span(disc.y, disc.vy, window, reach));
            self.blocks[block_of(x, y, square.side)].push(number as u32);
        }
    }
}

impl Find for Grid {
    fn find(
        &mut self,
        discs: &[Disc],
        _: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    ) {
        self.fill(discs, square, window);
        let blocks = &self.blocks;
        // One iteration for each disc: its block, and its place there.
        let places: Vec<(usize, usize)> = blocks
            .iter()
            .enumerate()
            .flat_map(|(block, discs)| (0..discs.len()).map(move |place| (block, place)))
            .collect();
        let around: Vec<Vec<usize>> = (0..BLOCKS).map(blocks_around).collect();

        let team = Team::Standing(&self.workers);
        found.clear(team.count());
        let lists: Vec<_> = found.lists.drain(..).map(Mutex::new).collect();
        let tests = AtomicU64::new(0);
        team.run(places.len(), Schedule::Dynamic { chunk: self.chunk }, |worker, part| {
            let mut list = lists[worker].lock().expect("no worker panics while it looks");
            let mut looked = 0;
            for &(block, place) in &places[part] {
                let number = blocks[block][place];
                let others = around[block].iter().map(|&other| &blocks[other][..]);
                for others in others.chain([&blocks[block][place + 1..]]) {
                    looked += others.len() as u64;
                    for &other in others {
                        let (a, b) = (number.min(other), number.max(other));
                        if let Some(hit) = pair_hit(discs, a, b, square.radius) {
                            list.push(hit);
                        }
                    }
                }
            }
            tests.fetch_add(looked, Ordering::Relaxed);
        });
        found.lists.extend(lists.into_iter().map(|l| l.into_inner().expect("as above")));
        found.pair_tests += tests.into_inner();
    }
}
