//! The search in the report's grid of three levels.

use std::marker::PhantomData;
use std::ops::Range;

use common::hard::Disc;
use workers::Workers;

use crate::broad_phase::BroadPhase;
use crate::collisions::Collisions;
use crate::find::{Find, Found, Lists};
use crate::geometry::{Square, Window, reach};
use crate::parallel_loops::ParallelLoops;
use crate::survey::Survey;
use crate::threads::{Schedule, Team};

/// Number of blocks of all levels.
///
/// There are 4 × 4 small blocks with numbers 0 to 15 and 2 × 2 medium blocks with numbers 16 to 19.
/// Block 20 is the whole square.
pub const BLOCKS: usize = 21;

/// The unit of work that a worker takes from the queue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deal {
    /// A chunk with this number of discs.
    Discs(usize),
    /// A whole block.
    Blocks,
}

/// A search that puts every disc into the smallest block that contains the disc's swept box.
///
/// The swept box contains all points that the disc can touch in the window that is searched.
/// A disc can meet only the discs of its block and of blocks that overlap this block.
pub struct Grid<C> {
    rules: PhantomData<C>,
    workers: Workers,
    deal: Deal,
    blocks: Vec<Vec<u32>>,
}

impl<C: BroadPhase> Grid<C> {
    /// Makes a grid. The `workers` take the work of a search from a queue, in units of `deal`.
    pub fn new(workers: Workers, deal: Deal) -> Self {
        Self { rules: PhantomData, workers, deal, blocks: vec![Vec::new(); BLOCKS] }
    }

    fn fill(&mut self, discs: &[Disc], square: Square, window: Window) {
        let reach = reach(square, Survey::of(discs, square).fastest);
        self.blocks.iter_mut().for_each(Vec::clear);
        for (number, disc) in discs.iter().enumerate() {
            let x = C::span(disc.x, disc.vx, window, reach);
            let y = C::span(disc.y, disc.vy, window, reach);
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
        // Each iteration of the loop is a block and a range of indices into the block's discs.
        let all_discs = blocks.iter().enumerate().map(|(block, discs)| (block, 0..discs.len()));
        let (iterations, chunk): (Vec<(usize, Range<usize>)>, _) = match self.deal {
            Deal::Blocks => (all_discs.collect(), 1),
            Deal::Discs(chunk) => {
                let discs = all_discs.flat_map(|(block, all)| all.map(move |k| (block, k..k + 1)));
                (discs.collect(), chunk)
            }
        };
        let team = Team::Standing(&self.workers);
        let lists = Lists::take(found, team.count());
        C::parallel_for(iterations.len(), team, Schedule::Dynamic { chunk }, |worker, part| {
            let (list, tests) = &mut *lists.of(worker);
            for (block, indices) in &iterations[part] {
                for index in indices.clone() {
                    let disc = blocks[*block][index];
                    C::look_around(blocks, *block, index, |partners| {
                        *tests += partners.len() as u64;
                        for &partner in partners {
                            let a = disc.min(partner);
                            let b = disc.max(partner);
                            if let Some(hit) = C::pair_hit(discs, a, b, square.radius) {
                                list.push(hit);
                            }
                        }
                    });
                }
            }
        });
        lists.write_back(found);
    }
}
