//! Questions about bins that are emptied and refilled, by one thread and by their owners.

use std::panic::{AssertUnwindSafe, catch_unwind};

use common::soft::Particle;
use lab4::{Bin, Regions, claim, rebuild, take_own};
use oracle::scenes::on_edges;
use oracle::{Ask, Random, Table, ascending, integers, truth};
use solution2::{Grid, SortedBins};

use super::bins::{filled, inside, places, regions_of};

/// Asks for the contents of bins that `fill` refills after other particles. The new particles are
/// on walls and edges of many bins, or many are in a single bin, or there are none.
fn fills(random: &mut Random, ask: &mut impl Ask, fill: impl Fn(&mut Regions, &Grid, &[Particle])) {
    for n in [random.sizes(1025), vec![65_537, 3, 0]].concat() {
        let along = if n > 5000 { 1 } else { 1 + random.size(33) };
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), along);
        let particles = on_edges(random, n, grid.size(), along);
        let mut regions = filled(grid.bins(), 1 + random.size(grid.bins()));
        let before = memory_of(&mut regions);
        fill(&mut regions, &grid, &particles);
        let name = format!(
            "{n} particles, {along} bins along each wall of length {:e}. Each bin contained 30 other particles before",
            grid.size()
        );
        let poorer = regions.parts_mut().flatten().filter(|bin| bin.capacity() < 30).count();
        let question = format!("{name}: number of bins that released their memory");
        ask.exact(&question, || integers([poorer]), || integers([0]));
        let after = memory_of(&mut regions);
        // A bin with more particles than it had room for needs new memory.
        let moved = before.iter().zip(&after).filter(|(old, new)| old.1 == new.1 && old.0 != new.0);
        let question =
            format!("{name}: number of bins that have the same capacity as before but new memory");
        ask.exact(&question, || integers([moved.count()]), || integers([0]));
        let question = format!("{name}: id and bin of each particle that is in a bin");
        let found = || places(&mut regions);
        ask.judge(&question, found, |found| are_in_their_bins(&grid, &particles, found));
    }
}

/// Returns the address and the room of each bin's memory.
fn memory_of(regions: &mut Regions) -> Vec<(*const u32, usize)> {
    regions.parts_mut().flatten().map(|bin| (bin.as_ptr(), bin.capacity())).collect()
}

/// Checks that each particle is in its bin and in no other bin.
fn are_in_their_bins(grid: &Grid, particles: &[Particle], found: &[f64]) -> Result<(), String> {
    let mut bins = vec![Vec::new(); particles.len()];
    for [particle, bin] in found.as_chunks::<2>().0 {
        match bins.get_mut(*particle as usize) {
            Some(bins) => bins.push(*bin as usize),
            None => {
                return Err(format!(
                    "bin {bin} still contains particle {particle}, which was there before"
                ));
            }
        }
    }
    for (p, bins) in particles.iter().zip(bins) {
        let right = [grid.bin(p)];
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

/// Asks one thread to fill all bins.
pub(crate) fn by_one(random: &mut Random, ask: &mut impl Ask) {
    fills(random, ask, rebuild);
}

/// Makes each owner fill its own bins.
fn claim_all(regions: &mut Regions, grid: &Grid, particles: &[Particle]) {
    let cut = regions.cut;
    for (own, bins) in regions.parts_mut().enumerate() {
        claim(cut, own, bins, grid, particles);
    }
}

/// Asks owners to fill their bins.
pub(crate) fn by_owners(random: &mut Random, ask: &mut impl Ask) {
    fills(random, ask, claim_all);
}

/// Asks owners of some rows, of no rows and of the other rows. Each owner has a particle from
/// before.
pub(crate) fn owned_rows(random: &mut Random, ask: &mut impl Ask) {
    for n in [random.sizes(1025), vec![2, 0]].concat() {
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), 3 + random.size(300));
        let mut particles = on_edges(random, n, grid.size(), grid.rows());
        let cut = 1 + random.below(grid.rows() - 1);
        // A particle on the cut, where rounding decides which row has it.
        let y = cut as f64 * grid.size() / grid.rows() as f64;
        particles.push(Particle { y, id: n as u32, ..Particle::default() });
        for rows in [0..cut, cut..cut, cut..grid.rows()] {
            let mut own = SortedBins::new(grid, rows.clone());
            own.put(Particle { y: 0.5 * grid.size(), id: u32::MAX, ..Particle::default() });
            // Sorting exchanges two arrays. Each array has room for more particles than arrive.
            own.particles_mut().reserve(2000);
            // The owner's bins refuse a particle outside their rows.
            let take = AssertUnwindSafe(|| {
                take_own(&mut own, [].iter());
                own.particles_mut().reserve(2000);
                take_own(&mut own, particles.iter());
            });
            let taken = catch_unwind(take);
            let room = own.particles_mut().capacity();
            let found = || taken.map_or(vec![-1.0], |()| ids(own.particles()));
            let question = format!(
                "{n} particles and one more on the cut, and the owner of rows {rows:?} of {}: the particles that the \
                 owner takes, or -1 if it takes a particle that is in none of its rows",
                grid.rows()
            );
            ask.exact(&question, found, || {
                ids(particles.iter().filter(|p| rows.contains(&grid.row(p.y))))
            });
            let question = format!(
                "{n} particles and one more on the cut, and the owner of rows {rows:?}: 1 if the owner releases its \
                 memory, 0 if not"
            );
            ask.exact(&question, || vec![truth(room < 2000)], || vec![0.0]);
        }
    }
}

/// Returns the ids of particles, in ascending order.
fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    let mut ids: Vec<usize> = particles.into_iter().map(|p| p.id as usize).collect();
    ids.sort_unstable();
    integers(ids)
}

/// Returns two bins along each wall, of side 1. Two regions of two bins still hold particles of the
/// previous step.
fn four_bins() -> (Grid, Regions) {
    let before: [Bin; 4] = [vec![0, 1], vec![2], vec![], vec![3, 4]];
    (Grid::with_bins_along(2.0, 2), regions_of(2, &before))
}

/// Returns five particles, the last of them on the wall.
fn five() -> Vec<Particle> {
    let places = [(0.5, 0.5), (1.5, 0.5), (0.5, 1.5), (0.7, 1.2), (2.0, 2.0)];
    let particle = |(id, (x, y))| Particle { x, y, id, ..Particle::default() };
    (0..).zip(places).map(particle).collect()
}

/// Shows the particles and the bins before and after `fill`.
fn filled_again(fill: impl Fn(&mut Regions, &Grid, &[Particle])) -> String {
    let (grid, mut regions) = four_bins();
    let particles = five();
    let mut table = Table::new(["particle", "x", "y"]);
    particles.iter().for_each(|p| table.row([&p.id, &p.x, &p.y]));
    let before = inside(&mut regions, [0, 1, 2, 3]);
    fill(&mut regions, &grid, &particles);
    let after = inside(&mut regions, [0, 1, 2, 3]);
    let mut bins = Table::new(["bin", "region", "particles before", "particles after"]);
    for bin in 0..4 {
        bins.row([&bin, &(bin / 2), &before[bin], &after[bin]]);
    }
    format!("{table}\n{bins}")
}

/// Shows the worked example of one thread.
pub(crate) fn table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| filled_again(rebuild));
}

/// Shows the worked example of owners, in regions and in rows.
pub(crate) fn owners_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut rows = Table::new(["owner of rows", "particles that it takes"]);
        for own in [0..1, 1..2, 2..2] {
            let mut bins = SortedBins::new(Grid::with_bins_along(2.0, 2), own.clone());
            take_own(&mut bins, five().iter());
            let taken = ascending(bins.particles().iter().map(|p| p.id));
            rows.row([&format!("{own:?}"), &taken]);
        }
        format!("{}\n{rows}", filled_again(claim_all))
    });
}
