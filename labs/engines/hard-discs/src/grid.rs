//! A search in the report's grid of three levels.

use std::marker::PhantomData;

use common::hard::Disc;

use crate::broad_phase::BroadPhase;
use crate::collisions::Collisions;
use crate::find::{Find, Found};
use crate::lists::Lists;
use crate::parallel_loops::ParallelLoops;
use crate::span::reach;
use crate::square::Square;
use crate::survey::Survey;
use crate::threads::{Schedule, Team, Workers};
use crate::window::Window;

/// Blocks of all levels: 4 × 4 small ones, numbers 0 to 15; 2 × 2 medium ones, 16 to 19; the
/// whole square, 20.
pub const BLOCKS: usize = 21;

/// Every disc is in the smallest block that its box of this step fits into. It can only meet the
/// discs of the same block and of the blocks around.
pub struct Grid<C> {
    rules: PhantomData<C>,
    workers: Workers,
    chunk: usize,
    blocks: Vec<Vec<u32>>,
}

impl<C: BroadPhase> Grid<C> {
    /// A grid whose discs are dealt out to `workers` from a queue, `chunk` discs at a time.
    pub fn new(workers: Workers, chunk: usize) -> Self {
        Self { rules: PhantomData, workers, chunk, blocks: vec![Vec::new(); BLOCKS] }
    }

    fn fill(&mut self, discs: &[Disc], square: Square, window: Window) {
        let reach = reach(square, Survey::of(discs, square).fastest);
        self.blocks.iter_mut().for_each(Vec::clear);
        for (number, disc) in discs.iter().enumerate() {
            let (x, y) =
                (C::span(disc.x, disc.vx, window, reach), C::span(disc.y, disc.vy, window, reach));
            self.blocks[C::block_of(x, y, square.side)].push(number as u32);
        }
    }
}

impl<C: Collisions + BroadPhase + ParallelLoops> Find for Grid<C> {
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
        let around: Vec<Vec<usize>> = (0..BLOCKS).map(C::blocks_around).collect();

        let team = Team::Standing(&self.workers);
        let lists = Lists::take(found, team.count());
        let schedule = Schedule::Dynamic { chunk: self.chunk };
        C::parallel_for(indices.len(), team, schedule, |worker, part| {
            let (list, tests) = &mut *lists.of(worker);
            for &(block, index) in &indices[part] {
                let disc = blocks[block][index];
                let coarser = around[block].iter().map(|&block| &blocks[block][..]);
                for partners in coarser.chain([&blocks[block][index + 1..]]) {
                    *tests += partners.len() as u64;
                    for &partner in partners {
                        let (a, b) = (disc.min(partner), disc.max(partner));
                        if let Some(hit) = C::pair_hit(discs, a, b, square.radius) {
                            list.push(hit);
                        }
                    }
                }
            }
        });
        lists.write_back(found);
    }
}
