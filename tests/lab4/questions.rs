//! What tests and probe ask alike, with drawn inputs and what a plain model says.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle};
use common_threads::Lock;
use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{
    Bin, Change, Cut, Regions, apply_all, apply_own, claim, move_own, pairs_across, pairs_within,
    post, rebuild, receive, send, take, take_own,
};
use solution1::{Tally, advance};
use solution2::{Grid, SortedBins};

use super::ask::{Ask, rounded, whole};
use super::locked::filled;
use super::{acceleration_of_pair, on_edges};
use crate::Random;

/// Few regions and many, of few bins and many.
pub(super) fn regions(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        // One in ten has many of both.
        let most = if case % 10 == 9 { 70_000 } else { 1025 };
        let (bins, count) = (1 + random.size(most), 1 + random.size(most));
        let mut regions = Regions::new(bins, count);
        let found = whole(regions.parts_mut().map(|bins| bins.len()));
        let each = bins.div_ceil(count);
        let right = (0..bins.div_ceil(each)).map(|number| each.min(bins - number * each));
        let question = format!("{bins} bins in {count} regions or less: bins in each");
        ask(&question, found, whole(right));
        let each = 1 + random.size(70_000);
        for bin in [random.size(70_000), random.size(1 << 40)] {
            let (region, index) = Cut { bins_each: each }.find(bin);
            let question = format!("region and index of bin {bin}, {each} bins in a region");
            ask(&question, whole([region, index]), whole([bin / each, bin % each]));
        }
    }
}

/// Particles with any ids in any bins, and those of them that change their bins, in several buffers.
struct Changes {
    bins: usize,
    cut: Cut,
    /// Where each particle is at first.
    residents: Vec<(usize, u32)>,
    changes: Vec<Change>,
    /// Where buffers end; some are empty.
    ends: Vec<usize>,
}

impl Changes {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let bins = [2, 12, 300, 70_000][case % 4];
        let bins_each = [1, 1 + random.below(6), 1 + random.size(bins)][random.below(3)];
        let (n, apart) = (random.size(4097), [1, 1 << 16, 1_000_003][random.below(3)]);
        let (mut residents, mut changes) = (Vec::new(), Vec::new());
        for k in 0..n {
            let (from, to, particle) = (random.below(bins), random.below(bins), (k * apart) as u32);
            residents.push((from, particle));
            if from != to {
                changes.push(Change { particle, from, to });
            }
        }
        random.shuffle(&mut changes);
        let all = changes.len();
        let mut ends: Vec<usize> = (0..random.size(33)).map(|_| random.below(all + 1)).collect();
        ends.extend([0, all, all]);
        ends.sort_unstable();
        Self { bins, cut: Cut { bins_each }, residents, changes, ends }
    }

    fn name(&self) -> String {
        format!(
            "{} particles in {} bins, up to {} bins in a region, {} changes in {} buffers, some of them empty",
            self.residents.len(),
            self.bins,
            self.cut.bins_each,
            self.changes.len(),
            self.ends.len() - 1
        )
    }

    fn regions(&self) -> Regions {
        let each = self.cut.bins_each;
        let region = |number: usize| {
            Lock::new(number, vec![Bin::new(); each.min(self.bins - number * each)])
        };
        let locks = (0..self.bins.div_ceil(each)).map(region).collect();
        let mut regions = Regions { cut: self.cut, locks };
        for (bin, particle) in &self.residents {
            regions.locks[bin / each].get_mut()[bin % each].push(*particle);
        }
        regions
    }

    fn buffers(&self) -> impl Iterator<Item = &[Change]> {
        self.ends.windows(2).map(|ends| &self.changes[ends[0]..ends[1]])
    }

    /// What each owner must be told, in the order of changes.
    fn letters(&self) -> Vec<(usize, Change)> {
        let mut all = Vec::new();
        for change in &self.changes {
            let [from, to] = [change.from, change.to].map(|bin| bin / self.cut.bins_each);
            all.push((from, *change));
            if from != to {
                all.push((to, *change));
            }
        }
        all
    }

    /// The owners that a change concerns, and a few others.
    fn owners(&self) -> Vec<usize> {
        let count = self.bins.div_ceil(self.cut.bins_each);
        let concerned = self.letters().into_iter().map(|(owner, _)| owner);
        let mut owners: Vec<usize> = (0..count.min(3)).chain(concerned).collect();
        owners.sort_unstable();
        owners.dedup();
        owners
    }

    /// Asks where all particles are.
    fn ask(&self, how: &str, regions: &mut Regions, ask: Ask<'_>) {
        let mut found: HashMap<u32, Vec<usize>> = HashMap::new();
        for (bin, inside) in regions.parts_mut().flatten().enumerate() {
            inside.iter().for_each(|particle| found.entry(*particle).or_default().push(bin));
        }
        let to: HashMap<u32, usize> = self.changes.iter().map(|c| (c.particle, c.to)).collect();
        let name = format!("{}, {how}", self.name());
        for (bin, particle) in &self.residents {
            let bins = found.remove(particle).unwrap_or_default();
            let right = to.get(particle).unwrap_or(bin);
            if bins != [*right] {
                let question = format!(
                    "{name}: the bins that hold particle {particle}, which was in bin {bin} and {}",
                    if right == bin { "stays".into() } else { format!("goes to bin {right}") }
                );
                return ask(&question, whole(bins), whole([*right]));
            }
        }
        ask(&format!("{name}: particles that were never there"), whole([found.len()]), whole([0]));
    }

    /// Asks what each owner has been told.
    fn ask_letters(&self, found: Vec<(usize, Change)>, ask: Ask<'_>) {
        let mut told: BTreeMap<[usize; 4], [usize; 2]> = BTreeMap::new();
        for (side, letters) in [found, self.letters()].into_iter().enumerate() {
            for (owner, c) in letters {
                told.entry([owner, c.particle as usize, c.from, c.to]).or_default()[side] += 1;
            }
        }
        let wrong = told.iter().find(|(_, [found, right])| found != right);
        let ([owner, particle, from, to], [found, right]) =
            wrong.or(told.iter().next()).unwrap_or((&[0; 4], &[0; 2]));
        let question = format!(
            "{}: how often owner {owner} is told that particle {particle} goes from bin {from} to {to}",
            self.name()
        );
        ask(&question, whole([*found]), whole([*right]));
    }
}

/// The changes of all buffers, made by one.
pub(super) fn by_one(random: &mut Random, ask: Ask<'_>) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        apply_all(&mut regions, all.buffers());
        all.ask("by one", &mut regions, ask);
    }
}

/// The changes of all buffers, made by the owners.
pub(super) fn by_owners(random: &mut Random, ask: Ask<'_>) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        for own in all.owners() {
            let bins = regions.locks[own].get_mut();
            apply_own(all.cut, own, bins, all.buffers().flatten().copied());
        }
        all.ask("by the owners", &mut regions, ask);
    }
}

/// Changes through queues: who is told, and what comes of it.
pub(super) fn queues(random: &mut Random, ask: Ask<'_>) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        let queues: Vec<_> = regions.locks.iter().map(|_| SegQueue::new()).collect();
        all.changes.iter().for_each(|change| post(all.cut, &queues, *change));
        let mut told = Vec::new();
        for (owner, queue) in queues.iter().enumerate() {
            told.extend(std::iter::from_fn(|| queue.pop()).map(|change| (owner, change)));
        }
        all.ask_letters(told, ask);
        all.letters().into_iter().for_each(|(owner, change)| queues[owner].push(change));
        for own in all.owners() {
            take(all.cut, own, regions.locks[own].get_mut(), &queues[own]);
        }
        let left = queues.iter().map(SegQueue::len).sum();
        ask(&format!("{}: left in the queues", all.name()), whole([left]), whole([0]));
        all.ask("from queues", &mut regions, ask);
    }
}

/// Changes through channels.
pub(super) fn channels(random: &mut Random, ask: Ask<'_>) {
    for case in 0..40 {
        let all = Changes::drawn(random, case);
        let mut regions = all.regions();
        let (senders, receivers): (Vec<_>, Vec<_>) =
            regions.locks.iter().map(|_| unbounded()).unzip();
        all.changes.iter().for_each(|change| send(all.cut, &senders, *change));
        let of = |owner: usize| receivers[owner].try_iter().map(move |change| (owner, change));
        all.ask_letters((0..senders.len()).flat_map(of).collect(), ask);
        let again = |(owner, change): (usize, Change)| {
            senders[owner].send(change).expect("it has a receiver");
        };
        all.letters().into_iter().for_each(again);
        for own in all.owners() {
            receive(all.cut, own, regions.locks[own].get_mut(), &receivers[own]);
        }
        all.ask("from channels", &mut regions, ask);
    }
}

/// Any number of particles, not from particle 0 on, in few bins or many.
pub(super) fn moves(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(1025), random.sizes(1025)].concat() {
        let along = [1 + random.size(40), 256, 300][random.below(3)];
        let size = along as f64 * CUTOFF;
        let grid = Grid::with_bins_along(size, along);
        let first = random.size(70_000) as u32;
        let speed = random.magnitude(1.0, 100.0);
        let particle = |id: u32| {
            let mut any = |low, high| random.between(low, high);
            let (x, y) = (any(0.0, size), any(0.0, size));
            let (vx, vy) = (any(-speed, speed), any(-speed, speed));
            Particle { x, y, vx, vy, id: first + id }
        };
        let mut particles: Vec<Particle> = (0..n as u32).map(particle).collect();
        let push = |p: &Particle| Vec2::new(f64::from(p.id), -f64::from(p.id));
        let accelerations: Vec<Vec2> = particles.iter().map(push).collect();
        let (mut right, mut right_changes, mut told) = (particles.clone(), Vec::new(), Vec::new());
        for (p, a) in right.iter_mut().zip(&accelerations) {
            let from = grid.bin(p);
            advance(p, *a, size);
            let to = grid.bin(p);
            if from != to {
                right_changes.extend([p.id as usize, from, to]);
            }
        }
        move_own(&grid, &mut particles, &accelerations, |change| {
            told.extend([change.particle as usize, change.from, change.to]);
        });
        let name = format!("{n} particles from {first} on, in {along} rows of bins");
        let numbers =
            |all: &[Particle]| all.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect::<Vec<_>>();
        ask(&format!("{name}: x y vx vy of each"), numbers(&particles), numbers(&right));
        let question = format!("{name}: particle, old and new bin of each that was told of");
        ask(&question, whole(told), whole(right_changes));
    }
}

/// Bins with others in them are emptied and filled again by `fill`: with particles on walls and edges of many bins,
/// with many in a single one, and with none.
fn fills(random: &mut Random, fill: impl Fn(&mut Regions, &Grid, &[Particle]), ask: Ask<'_>) {
    for n in [random.sizes(1025), vec![65_537, 3, 0]].concat() {
        let along = if n > 5000 { 1 } else { 1 + random.size(33) };
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), along);
        let particles = on_edges(random, n, grid.size(), along);
        let mut regions = filled(grid.bins(), 1 + random.size(grid.bins()));
        fill(&mut regions, &grid, &particles);
        let mut found = vec![Vec::new(); n];
        let mut strangers = 0;
        for (bin, inside) in regions.parts_mut().flatten().enumerate() {
            for particle in inside.iter() {
                match found.get_mut(*particle as usize) {
                    Some(bins) => bins.push(bin),
                    None => strangers += 1,
                }
            }
        }
        let name = format!("{n} particles, {along} bins along a wall of {:e}", grid.size());
        ask(&format!("{name}: particles left from before"), whole([strangers]), whole([0]));
        for (p, bins) in particles.iter().zip(found) {
            let question =
                format!("{name}: the bins that hold particle {} at ({:?}, {:?})", p.id, p.x, p.y);
            let right = whole([grid.bin(p)]);
            let found = whole(bins);
            if found != right {
                return ask(&question, found, right);
            }
        }
    }
    ask("all particles are in their bins, and in no other", vec![], vec![]);
}

/// One thread fills all bins.
pub(super) fn rebuilds(random: &mut Random, ask: Ask<'_>) {
    fills(random, rebuild, ask);
}

/// Each owner fills its own.
pub(super) fn claims(random: &mut Random, ask: Ask<'_>) {
    let fill = |regions: &mut Regions, grid: &Grid, particles: &[Particle]| {
        let cut = regions.cut;
        for (own, bins) in regions.parts_mut().enumerate() {
            claim(cut, own, bins, grid, particles);
        }
    };
    fills(random, fill, ask);
}

/// Owners of some rows, of none and of the rest, each with one from before.
pub(super) fn owners(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(1025), vec![2, 0]].concat() {
        let grid = Grid::with_bins_along(random.magnitude(1e-6, 1e6), 3 + random.size(300));
        let mut particles = on_edges(random, n, grid.size(), grid.rows());
        let cut = 1 + random.below(grid.rows() - 1);
        // On the cut, where rounding decides which row has it.
        let y = cut as f64 * grid.size() / grid.rows() as f64;
        particles.push(Particle { y, id: n as u32, ..Particle::default() });
        for rows in [0..cut, cut..cut, cut..grid.rows()] {
            let mut own = SortedBins::new(grid, rows.clone());
            own.put(Particle { y: 0.5 * grid.size(), id: u32::MAX, ..Particle::default() });
            let name = format!(
                "{n} particles and one on the cut, the owner of rows {rows:?} of {}",
                grid.rows()
            );
            // Its bins do not hold one that lies in none of its rows.
            let taken = catch_unwind(AssertUnwindSafe(|| take_own(&mut own, particles.iter())));
            let question = format!("{name}: has it taken one that lies in none of them, 1 for yes");
            ask(&question, whole([usize::from(taken.is_err())]), whole([0]));
            let ids = |all: &mut Vec<u32>| {
                all.sort_unstable();
                whole(all.iter().map(|id| *id as usize))
            };
            let mut found = own.particles().iter().map(|p| p.id).collect();
            let right = particles.iter().filter(|p| rows.contains(&grid.row(p.y)));
            let mut right = right.map(|p| p.id).collect();
            ask(&format!("{name}: the particles that it has"), ids(&mut found), ids(&mut right));
        }
    }
}

/// What an owner finds and adds to: forces from before, and what pairs make of them.
struct Sums {
    found: Vec<Vec2>,
    right: Vec<Vec2>,
    scale: Vec<f64>,
}

impl Sums {
    fn from_before(random: &mut Random, n: usize) -> Self {
        let mut any = || random.signed(1e-3, 1e3);
        let found: Vec<Vec2> = (0..n).map(|_| Vec2::new(any(), any())).collect();
        let scale = found.iter().map(|a| a.norm_squared().sqrt()).collect();
        Self { right: found.clone(), found, scale }
    }

    fn zero(n: usize) -> Self {
        Self { found: vec![Vec2::ZERO; n], right: vec![Vec2::ZERO; n], scale: vec![0.0; n] }
    }

    fn add(&mut self, i: usize, a: Vec2) {
        self.right[i] += a;
        self.scale[i] += a.norm_squared().sqrt();
    }

    fn ask(&self, question: &str, ask: Ask<'_>) {
        let all = self.found.iter().zip(&self.right).zip(&self.scale);
        let near =
            |((f, r), s): ((&Vec2, &Vec2), &f64)| [rounded(f.x, r.x, *s), rounded(f.y, r.y, *s)];
        let right = self.right.iter().flat_map(|a| [a.x, a.y]).collect();
        ask(question, all.flat_map(near).collect(), right);
    }
}

/// Particles in some rows of bins a little wider than a cutoff, few or many in reach of each.
fn strip(random: &mut Random, grid: Grid, rows: Range<usize>, n: usize) -> SortedBins {
    let side = grid.bin_side();
    let extent = (n as f64 / random.magnitude(0.3, 10.0)).sqrt().max(1.0) * CUTOFF;
    let particle = |id| {
        let y = random.between(rows.start as f64 + 0.01, rows.end as f64 - 0.01) * side;
        let x = random.between(0.0, extent.min(grid.size()));
        Particle { x, y, id, ..Particle::default() }
    };
    let particles: Vec<Particle> = (0..n as u32).map(particle).collect();
    let mut bins = SortedBins::new(grid, rows);
    bins.refill(particles);
    bins
}

/// Ordered pairs within the cutoff and pairs looked at, as an observer was told, beside what is right.
fn ask_counts(name: &str, tally: &Tally, right: [usize; 2], ask: Ask<'_>) {
    let seen = tally.statistics().expect("a tally has statistics");
    let question = format!("{name}: how often pairs were seen, twice each, and pairs looked at");
    ask(&question, whole([seen.navg as usize, seen.pair_tests as usize]), whole(right));
}

/// The pairs of some rows, added to what is there already.
pub(super) fn within_rows(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(1025), random.sizes(257)].concat() {
        let along = [1, 2, 5, 300][random.below(4)];
        let grid = Grid::with_bins_along(1.02 * along as f64 * CUTOFF, along);
        let start = random.below(along);
        let rows = start..start + 1 + random.below((along - start).min(4));
        let bins = strip(random, grid, rows.clone(), n);
        let mut sums = Sums::from_before(random, n);
        let (mut tally, mut counts) = (Tally::default(), [0; 2]);
        pairs_within(&bins, &mut sums.found, &mut tally);
        let all = bins.particles();
        for (i, j) in (0..n).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let (p, q) = (&all[i], &all[j]);
            let far = grid.row(p.y).abs_diff(grid.row(q.y));
            if far.max(grid.column(p.x).abs_diff(grid.column(q.x))) <= 1 {
                let d = p.to(q);
                let a = acceleration_of_pair(d.x, d.y);
                sums.add(i, a);
                sums.add(j, -a);
                counts[0] += 2 * usize::from(d.norm_squared() <= CUTOFF * CUTOFF);
                counts[1] += 1;
            }
        }
        let name = format!("{n} particles in rows {rows:?} of {along}");
        sums.ask(&format!("{name}: accelerations, added to those from before"), ask);
        ask_counts(&name, &tally, counts, ask);
    }
}

/// The pairs across a cut.
pub(super) fn across(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(1025), random.sizes(257)].concat() {
        let along = [2, 5, 300][random.below(3)];
        let grid = Grid::with_bins_along(1.02 * along as f64 * CUTOFF, along);
        let cut = 1 + random.below(along - 1);
        let lower = strip(random, grid, cut.saturating_sub(2)..cut, n);
        let upper = strip(random, grid, cut..along.min(cut + 2), n);
        let first_row = &upper.particles()[upper.indices(cut..cut + 1)];
        let mut below = Sums::from_before(random, n);
        let mut above = Sums::zero(first_row.len());
        let (mut tally, mut counts) = (Tally::default(), [0; 2]);
        pairs_across(&lower, &upper, &mut below.found, &mut above.found, &mut tally);
        for (i, p) in lower.particles().iter().enumerate().filter(|(_, p)| grid.row(p.y) + 1 == cut)
        {
            for (k, q) in first_row.iter().enumerate() {
                if grid.column(p.x).abs_diff(grid.column(q.x)) <= 1 {
                    let d = p.to(q);
                    let a = acceleration_of_pair(d.x, d.y);
                    below.add(i, a);
                    above.add(k, -a);
                    counts[0] += 2 * usize::from(d.norm_squared() <= CUTOFF * CUTOFF);
                    counts[1] += 1;
                }
            }
        }
        let name = format!("{n} particles on each side of row {cut} of {along}");
        below.ask(&format!("{name}: below, added to those from before"), ask);
        above.ask(&format!("{name}: kept apart for the first row above"), ask);
        ask_counts(&name, &tally, counts, ask);
    }
}
