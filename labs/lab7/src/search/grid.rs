//! A search in the report's grid of three levels.

use common::hard::Disc;

use super::{Find, Found, Lists};
use crate::{
    BLOCKS, Schedule, Square, Survey, Team, Window, Workers, block_of, blocks_around, pair_hit,
    reach, span,
};

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
        // One iteration for each disc: its block, and its index there.
        let indices: Vec<(usize, usize)> = blocks
            .iter()
            .enumerate()
            .flat_map(|(block, discs)| (0..discs.len()).map(move |index| (block, index)))
            .collect();
        let around: Vec<Vec<usize>> = (0..BLOCKS).map(blocks_around).collect();

        let team = Team::Standing(&self.workers);
        let lists = Lists::take(found, team.count());
        team.run(indices.len(), Schedule::Dynamic { chunk: self.chunk }, |worker, part| {
            let (list, tests) = &mut *lists.of(worker);
            for &(block, index) in &indices[part] {
                let disc = blocks[block][index];
                let coarser = around[block].iter().map(|&block| &blocks[block][..]);
                for partners in coarser.chain([&blocks[block][index + 1..]]) {
                    *tests += partners.len() as u64;
                    for &partner in partners {
                        let (a, b) = (disc.min(partner), disc.max(partner));
                        if let Some(hit) = pair_hit(discs, a, b, square.radius) {
                            list.push(hit);
                        }
                    }
                }
            }
        });
        lists.put_back(found);
    }
}
