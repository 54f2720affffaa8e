//! What tests and probe ask alike, with drawn inputs and what a plain model says: `ask` gets a question, what the
//! lab answers and what is right.

use common::soft::Particle;
use lab2::{BinLists, Grid, take_leavers};

use crate::Random;

type Ask<'a> = &'a mut dyn FnMut(&str, Vec<usize>, Vec<usize>);

/// A particle well inside a bin of a box of side 1 with so many bins along a wall.
pub(super) fn inside(
    random: &mut Random,
    along: usize,
    row: usize,
    column: usize,
    id: usize,
) -> Particle {
    let mut place = |at: usize| (at as f64 + random.between(0.05, 0.95)) / along as f64;
    Particle { x: place(column), y: place(row), id: id as u32, ..Particle::default() }
}

/// Each of up to eleven particles has stayed in its bin, or left its row, or its column, or both.
pub(super) fn leavers(random: &mut Random, ask: Ask<'_>) {
    const ALONG: usize = 4;
    let grid = Grid::with_bins_along(1.0, ALONG);
    for case in 0..1500 {
        let (row, column) = (random.below(ALONG), random.below(ALONG));
        let (mut particles, mut stay, mut left) = (Vec::new(), Vec::new(), vec![99]);
        for id in 0..random.below(12) {
            let [far_up, far_right] = [0, 1].map(|_| random.below(2) * (1 + random.below(3)));
            let (to_row, to_column) = ((row + far_up) % ALONG, (column + far_right) % ALONG);
            particles.push(inside(random, ALONG, to_row, to_column, id));
            if far_up + far_right == 0 { &mut stay } else { &mut left }.push(id);
        }
        left.sort_unstable();
        let mut changed = vec![inside(random, ALONG, 0, 0, 99)];
        let all = particles.len();
        take_leavers(&grid, row * ALONG + column, &mut particles, &mut changed);
        let bin = format!("case {case}, bin of row {row}, column {column} with {all} particles");
        ask(&format!("{bin}, {left:?} changed: which stay"), ids(&particles), stay);
        ask(&format!("{bin}: which have left, and 99 from before"), ids(&changed), left);
    }
}

/// Lists are cleared and filled again, in any order: the last particle of a bin that came in comes first.
pub(super) fn lists(random: &mut Random, ask: Ask<'_>) {
    let mut lists = BinLists::new(6, 40);
    for round in 0..50 {
        lists.clear();
        let mut expected = vec![Vec::new(); 6];
        let mut order: Vec<usize> = (0..40).collect();
        random.shuffle(&mut order);
        for particle in order {
            let bin = random.below(6);
            lists.insert(bin, particle);
            expected[bin].insert(0, particle);
        }
        for (bin, expected) in expected.into_iter().enumerate() {
            let found = lists.bin(bin).take(50).collect();
            ask(&format!("round {round}, the list of bin {bin}"), found, expected.clone());
            for (place, particle) in expected.iter().enumerate() {
                let after = lists.after(*particle).take(50).collect();
                let question = format!("round {round}, those after particle {particle}");
                ask(&question, after, expected[place + 1..].to_vec());
            }
        }
    }
}

/// The numbers of particles, in their order.
fn ids(particles: &[Particle]) -> Vec<usize> {
    let mut ids: Vec<_> = particles.iter().map(|p| p.id as usize).collect();
    ids.sort_unstable();
    ids
}
