//! What tests and probe ask alike, with drawn inputs and what a plain model says: `ask` gets a question, what the
//! lab answers and what is right.

use std::ops::Range;

use common::soft::Particle;
use lab3::{own_rows, rebin_by_one, take_arrivals};
use solution2::{Grid, VecBins};

use crate::Random;

use super::on_edges;

type Ask<'a> = &'a mut dyn FnMut(&str, Vec<usize>, Vec<usize>);

/// Every row has one owner, in order, and no owner has more than a row more than another.
pub(super) fn rows(random: &mut Random, ask: Ask<'_>) {
    for case in 0..120 {
        // One in three has many of both.
        let most = if case % 3 == 0 { 70_000 } else { 40 };
        let (rows, workers) = (random.size(most), 1 + random.size(most));
        let (mut next, mut sizes) = (0, Vec::new());
        let name = format!("{rows} rows among {workers} workers");
        for worker in 0..workers {
            let own = own_rows(worker, workers, rows);
            // Asked only where it is wrong, or the answers would be more than a page.
            if own.start != next {
                ask(
                    &format!("{name}: the first row of worker {worker}"),
                    vec![own.start],
                    vec![next],
                );
            }
            next = own.end;
            sizes.push(own.len());
        }
        ask(&format!("{name}: the end of the last one's"), vec![next], vec![rows]);
        let uneven = sizes.iter().max().unwrap_or(&0) - sizes.iter().min().unwrap_or(&0);
        let question = format!("{name}: rows that one has more than another, beyond 1");
        ask(&question, vec![uneven.saturating_sub(1)], vec![0]);
    }
}

/// A few particles on walls and edges of many bins, or many in a single bin, in many buffers or a few; and rows of
/// bins, in the first of which there is a particle before they come.
struct Leavers {
    grid: Grid,
    rows: Range<usize>,
    leavers: Vec<Particle>,
    resident: Particle,
    each: usize,
}

impl Leavers {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let many = case % 10 == 9;
        let along = if many { 1 } else { 1 + random.size(300) };
        let n = if many { 65_537 } else { random.size(600) };
        let size = random.between(0.1, 9.0);
        let start = random.below(along);
        let rows = start..start + 1 + random.below(along - start);
        let leavers = on_edges(random, n, size, along);
        let middle = |bin: usize| (bin as f64 + 0.5) * (size / along as f64);
        let (x, y) = (middle(0), middle(rows.start));
        let resident = Particle { x, y, id: n as u32, ..Particle::default() };
        let grid = Grid::with_bins_along(size, along);
        Self { grid, rows, leavers, resident, each: 1 + random.size(40) }
    }

    fn buffers(&self) -> impl Iterator<Item = &[Particle]> {
        self.leavers.chunks(self.each)
    }

    fn name(&self) -> String {
        let (along, n, count) = (self.grid.rows(), self.leavers.len(), self.buffers().count());
        let size = self.grid.size();
        format!(
            "particles 0 to {n}, the last in its bin, the others in {count} buffers, {along} bins along {size:?}"
        )
    }

    /// Asks for the bins that each particle is in, of `bins`, which begin with the first of `rows`.
    fn ask(&self, rows: &Range<usize>, bins: &[Vec<Particle>], ask: Ask<'_>) {
        let first = rows.start * self.grid.columns();
        let mut found = vec![Vec::new(); self.leavers.len() + 1];
        for (bin, inside) in (first..).zip(bins) {
            inside.iter().for_each(|p| found[p.id as usize].push(bin));
        }
        let name = self.name();
        let mut all = [0; 2];
        for (p, found) in self.leavers.iter().chain([&self.resident]).zip(found) {
            let expected = rows.contains(&self.grid.row(p.y)).then(|| self.grid.bin(p));
            let expected: Vec<usize> = expected.into_iter().collect();
            all = [all[0] + found.len(), all[1] + expected.len()];
            if found != expected {
                let question = format!(
                    "{name}, those of rows {rows:?}: the bins that hold particle {} at ({:?}, {:?})",
                    p.id, p.x, p.y
                );
                return ask(&question, found, expected);
            }
        }
        ask(&format!("{name}: particles in the bins of rows {rows:?}"), vec![all[0]], vec![all[1]]);
    }
}

/// All particles of all buffers go into their bins.
pub(super) fn by_one(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let mut bins = VecBins::new(leavers.grid);
        bins.put(leavers.resident);
        rebin_by_one(&mut bins, leavers.buffers());
        leavers.ask(&(0..leavers.grid.rows()), bins.bins(), ask);
    }
}

/// Those that lie in the own rows go into their bins.
pub(super) fn by_all(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let (grid, rows) = (leavers.grid, leavers.rows.clone());
        let mut own = vec![Vec::new(); rows.len() * grid.columns()];
        own[0].push(leavers.resident);
        take_arrivals(&grid, rows.start * grid.columns(), &mut own, leavers.buffers());
        leavers.ask(&rows, &own, ask);
    }
}
