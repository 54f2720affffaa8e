//! Questions about emptying change buffers, by one thread and by all threads.

use std::ops::Range;

use common::soft::Particle;
use lab3::{rebin_by_one, take_arrivals};
use oracle::scenes::on_edges;
use oracle::{Ask, Random};
use solution2::{Grid, VecBins};

/// Particles in change buffers, and one particle that is in its bin already.
struct Leavers {
    grid: Grid,
    /// A range of rows of bins.
    rows: Range<usize>,
    /// Few particles on walls and edges of many bins, or many particles in a single bin.
    leavers: Vec<Particle>,
    /// A particle in the first bin of the rows.
    resident: Particle,
    /// The ends of the buffers; some buffers are empty.
    ends: Vec<usize>,
}

impl Leavers {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let many = case % 10 == 9;
        let along = if many { 1 } else { [1 + random.size(40), 300][case % 2] };
        let n = if many { 65_537 } else { random.size(600) };
        let size = random.between(0.1, 9.0);
        let start = random.below(along);
        let rows = start..start + 1 + random.below(along - start);
        let mut leavers = on_edges(random, n, size, along);
        // Particles on the edges of the rows, where rounding decides which row has the particle.
        for edge in [rows.start as f64, rows.end as f64] {
            for y in [edge * (size / along as f64), edge * size / along as f64] {
                let id = leavers.len() as u32;
                leavers.push(Particle { y: y.min(size), id, ..Particle::default() });
            }
        }
        let n = leavers.len();
        let middle = |bin: usize| (bin as f64 + 0.5) * (size / along as f64);
        let x = middle(0);
        let y = middle(rows.start);
        let resident = Particle { x, y, id: n as u32, ..Particle::default() };
        let grid = Grid::with_bins_along(size, along);
        // Many buffers or few; the first buffer or the last is empty.
        let end = n * random.below(2);
        let most = [40, 1025][random.below(2)];
        let mut ends: Vec<usize> = (0..random.size(most)).map(|_| random.below(n + 1)).collect();
        ends.extend([0, n, end]);
        ends.sort_unstable();
        Self { grid, rows, leavers, resident, ends }
    }

    fn buffers(&self) -> impl Iterator<Item = &[Particle]> {
        self.ends.windows(2).map(|ends| &self.leavers[ends[0]..ends[1]])
    }

    /// Asks for the bins that contain each particle. `bins` are the bins of `rows`.
    fn ask(&self, rows: &Range<usize>, bins: &[Vec<Particle>], ask: &mut impl Ask) {
        let n = self.leavers.len();
        let along = self.grid.rows();
        let question = format!(
            "{n} particles in {} change buffers, some of which are empty, and particle {n} in its bin. There are \
             {along} bins along each wall of length {:?}: id and bin of each particle in the bins of rows {rows:?}",
            self.buffers().count(),
            self.grid.size()
        );
        let first = rows.start * self.grid.columns();
        let found = || {
            let inside = (first..).zip(bins).flat_map(|(bin, inside)| {
                inside.iter().flat_map(move |p| [f64::from(p.id), bin as f64])
            });
            inside.collect()
        };
        ask.judge(&question, found, |found| self.are_in_their_bins(rows, found));
    }

    fn are_in_their_bins(&self, rows: &Range<usize>, found: &[f64]) -> Result<(), String> {
        let mut bins = vec![Vec::new(); self.leavers.len() + 1];
        for [id, bin] in found.as_chunks::<2>().0 {
            match bins.get_mut(*id as usize) {
                Some(bins) => bins.push(*bin as usize),
                None => {
                    return Err(format!("bin {bin} contains particle {id}, which does not exist"));
                }
            }
        }
        for (p, bins) in self.leavers.iter().chain([&self.resident]).zip(bins) {
            let own = rows.contains(&self.grid.row(p.y)).then(|| self.grid.bin(p));
            let right: Vec<usize> = own.into_iter().collect();
            if bins != right {
                return Err(format!(
                    "the bins that contain particle {}, which is at ({:?}, {:?})\n     found: {bins:?}\n  expected: \
                     {right:?}",
                    p.id, p.x, p.y
                ));
            }
        }
        Ok(())
    }
}

/// Asks one thread to put all particles of all buffers into their bins.
pub(crate) fn by_one(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let mut bins = VecBins::new(leavers.grid);
        bins.put(leavers.resident);
        rebin_by_one(&mut bins, leavers.buffers());
        leavers.ask(&(0..leavers.grid.rows()), bins.bins(), ask);
    }
}

/// Asks each thread to put the particles in its own rows into their bins.
pub(crate) fn by_all(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let leavers = Leavers::drawn(random, case);
        let grid = leavers.grid;
        let rows = leavers.rows.clone();
        let mut own = vec![Vec::new(); rows.len() * grid.columns()];
        own[0].push(leavers.resident);
        take_arrivals(&grid, rows.start * grid.columns(), &mut own, leavers.buffers());
        leavers.ask(&rows, &own, ask);
    }
}
