//! What tests and probe ask alike, with drawn inputs and what a plain model says.

use std::ops::Range;

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle, Scene, Simulation};
use lab2::{BinLists, Gather, Grid, LinkedList, SortedBins, VecBins, forward, take_leavers};
use solution1::Tally;

use super::ask::{Ask, beside, rounded, whole};
use super::{Count, acceleration_of_pair};
use crate::Random;

fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> Vec<f64> {
    whole(particles.into_iter().map(|p| p.id as usize))
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// A particle well inside a bin of a box of side 1 with `along` bins along a wall.
fn inside(random: &mut Random, along: usize, row: usize, column: usize, id: usize) -> Particle {
    let mut at = |index: usize| (index as f64 + random.between(0.05, 0.95)) / along as f64;
    Particle { x: at(column), y: at(row), id: id as u32, ..Particle::default() }
}

/// `n` particles well inside bins of some rows, each with its bin: in any, or all in one; some stand where the one
/// before stands.
fn binned(
    random: &mut Random,
    along: usize,
    rows: &Range<usize>,
    n: usize,
) -> Vec<(usize, Particle)> {
    let mut all: Vec<(usize, Particle)> = Vec::with_capacity(n);
    let any = |random: &mut Random| (rows.start + random.below(rows.len()), random.below(along));
    let (crowd, one) = (random.below(3) == 0, any(random));
    for id in 0..n {
        let (row, column) = if crowd { one } else { any(random) };
        let new = (row * along + column, inside(random, along, row, column, id));
        let before = all.last().filter(|_| random.below(5) == 0);
        let again = before.map(|&(bin, p)| (bin, Particle { id: id as u32, ..p }));
        all.push(again.unwrap_or(new));
    }
    all
}

/// Few and many particles, boxes of any size, of few bins and of too many: how many bins along a wall.
pub(super) fn grids(random: &mut Random, ask: Ask<'_>) {
    for (size, least, n) in
        [(1.0, 0.25, 100), (1.0, 0.3, 100), (1.0, 0.3, 0), (1.0, 0.01, 2), (0.2, 0.3, 5)]
    {
        grid(size, least, n, ask);
    }
    for case in 0..1200 {
        let n = [random.size(70_000), 1 << random.below(40), 1 + random.below(1 << 40)];
        let (n, least) = (n[case % 3], random.magnitude(1e-9, 1e9));
        // A wall that a whole number of the least bins fills is where rounding bites.
        let fit = [random.magnitude(1e-3, 1e7), (1 + random.below(3000)) as f64, 1e290];
        grid(fit[case / 3 % 3] * least, least, n, ask);
    }
}

fn grid(size: f64, least: f64, n: usize, ask: Ask<'_>) {
    let found = Grid::new(size, least, n).rows();
    let most = (8 * n as u128).isqrt().max(1);
    let right = [1.0 - 1e-15, 1.0 + 1e-15].map(|rounding| {
        ((size / (least * (1.0 + 1e-9)) * rounding) as u128).clamp(1, most) as usize
    });
    let right = if right.contains(&found) { found } else { right[0] };
    let question = format!(
        "bins along a wall of {size:?}, of sides of {least:?} or more and a margin of 1e-9 of that, at most \
         {most} for {n} particles"
    );
    ask(&question, whole([found]), whole([right]));
}

/// The column of coordinates well inside one, on both walls, next to the far one, and on edges.
pub(super) fn columns(random: &mut Random, ask: Ask<'_>) {
    for case in 0..900 {
        let along = 1 + [random.size(300), random.size(70_000), random.below(1 << 40)][case % 3];
        let size = random.magnitude(1e-9, 1e9);
        let grid = Grid::with_bins_along(size, along);
        let (last, column) = (along - 1, random.below(along));
        let at = |columns: f64| columns / along as f64 * size;
        let below = [size.next_down(), size.next_down().next_down()];
        let walls = [(0.0, 0), (-0.0, 0), (size, last), (below[0], last), (below[1], last)];
        let middle = (at(column as f64 + random.between(0.1, 0.9)), column);
        for (x, right) in walls.into_iter().chain([middle]) {
            let question =
                format!("the column of x = {x:?} among {along}, in a box of side {size:?}");
            ask(&question, whole([grid.column(x)]), whole([right]));
        }
        // Rounding may put an edge on either side.
        for x in beside(at(column as f64)).map(|x| x.clamp(0.0, size)) {
            let found = grid.column(x);
            let right = if found + 1 == column { found } else { column };
            let question = format!("x = {x:?} is where column {column} of {along} begins");
            ask(&question, whole([found]), whole([right]));
        }
    }
}

/// The rows next to the first, the last and any row.
pub(super) fn near(random: &mut Random, ask: Ask<'_>) {
    for along in random.sizes(70_000).into_iter().chain([1 << 40]).map(|size| size + 1) {
        let grid = Grid::with_bins_along(1.0, along);
        let any = [random.size(along), random.size(along), random.below(along)];
        let all = [0, 1, along / 2, along - 1].into_iter().chain(any);
        for index in all.filter(|index| *index < along) {
            let near = grid.near(index);
            let right = [if index == 0 { 0 } else { index - 1 }, along.min(index + 2)];
            let question = format!("the rows next to row {index} of {along}: first, last + 1");
            ask(&question, whole([near.start, near.end]), whole(right));
        }
    }
}

/// Bins that are filled again and again, with more and at last with less.
pub(super) fn refills(random: &mut Random, ask: Ask<'_>) {
    for (along, most) in [(1, 65_537), (2, 4097), (5, 257), (300, 1025)] {
        let mut bins = VecBins::new(Grid::with_bins_along(1.0, along));
        let often = (0..[1, 1000][usize::from(along == 5)]).map(|step| step % 40);
        for n in random.sizes(most).into_iter().chain(often).chain([2, 0, 1]) {
            let all = binned(random, along, &(0..along), n + 1);
            let particles: Vec<Particle> = all.iter().map(|(_, p)| *p).collect();
            bins.refill(&particles[..n]);
            bins.put(particles[n]);
            let mut right = vec![Vec::new(); along * along];
            for (bin, p) in &all {
                right[*bin].push(p);
            }
            let name = format!(
                "{along} bins along a wall, filled again with particles before number {n}, and that one put in"
            );
            let busy = bins.bins().iter().zip(right).enumerate();
            for (bin, (found, right)) in
                busy.filter(|(_, (found, right))| found.len() + right.len() > 0)
            {
                let question = format!("{name}: the particles in bin {bin}");
                ask(&question, sorted(ids(found)), sorted(ids(right)));
            }
        }
    }
}

/// The force on some of the particles. Beyond the nine bins around one the others are decoys, in reach of it: a program
/// that looks at them finds another force.
pub(super) fn nine_bins(random: &mut Random, ask: Ask<'_>) {
    for (along, most) in [(1, 1025), (2, 4097), (3, 1025), (7, 1025), (300, 257)] {
        let side = 1.02 * along as f64 * CUTOFF;
        for n in random.sizes(most).into_iter().filter(|&n| n > 0) {
            let mut all = binned(random, along, &(0..along), n);
            for (bin, p) in &mut all {
                (p.x, p.y) = (p.x * side, p.y * side);
                // Some of those next to a wall are on it.
                let on_the_wall = p.id % 3 == 0;
                for (index, x) in [(*bin % along, &mut p.x), (*bin / along, &mut p.y)] {
                    if on_the_wall && index + 1 == along {
                        *x = side;
                    }
                }
            }
            for _ in 0..4 {
                let (own, p) = all[random.below(n)];
                let far = |bin: usize, by: usize| (bin / by % along).abs_diff(own / by % along);
                let is_near = |bin: usize| far(bin, 1).max(far(bin, along)) <= 1;
                let mut bins = VecBins::new(Grid::with_bins_along(side, along));
                let (mut around, mut right, mut scale) = (0, Vec2::ZERO, 0.0);
                for &(bin, q) in &all {
                    let decoy = Particle { x: p.x + 0.3 * CUTOFF, y: p.y - 0.4 * CUTOFF, ..q };
                    bins.bins_mut()[bin].push(if is_near(bin) { q } else { decoy });
                    if is_near(bin) {
                        let a = acceleration_of_pair(q.x - p.x, q.y - p.y);
                        around += 1;
                        right += a;
                        scale += a.norm_squared().sqrt();
                    }
                }
                let mut count = Count::default();
                let a = bins.acceleration(&p, &mut count);
                let name = format!(
                    "particle {} at ({:?}, {:?}), {n} particles in {along} rows of bins of side {:?}",
                    p.id,
                    p.x,
                    p.y,
                    side / along as f64
                );
                let found = [rounded(a.x, right.x, scale), rounded(a.y, right.y, scale)];
                ask(&format!("{name}: its acceleration"), found.to_vec(), vec![right.x, right.y]);
                let question = format!(
                    "{name}: how many in the bins around it were looked at (`tested`), itself among them"
                );
                ask(&question, whole([count.tested as usize]), whole([around]));
            }
        }
    }
}

/// Each particle of a bin has stayed, or left its row, or its column, or both.
pub(super) fn leavers(random: &mut Random, ask: Ask<'_>) {
    for case in 0..800 {
        let along = if case < 100 { 4 } else { [4, 300][case % 2] };
        let grid = Grid::with_bins_along(1.0, along);
        let (row, column) = (random.below(along), random.below(along));
        // In the last case all leave.
        let all = [random.size(if case % 50 == 49 { 4097 } else { 12 }), 65_537]
            [usize::from(case == 799)];
        let (mut particles, mut stay, mut left) = (Vec::new(), Vec::new(), vec![99_999]);
        for id in 0..all {
            let [far_up, far_right] =
                [0, 1].map(|_| random.below(2) * (1 + random.below(along - 1)));
            let far_up = if case == 799 { 1 } else { far_up };
            let (to_row, to_column) = ((row + far_up) % along, (column + far_right) % along);
            particles.push(inside(random, along, to_row, to_column, id));
            if far_up + far_right == 0 { &mut stay } else { &mut left }.push(id);
        }
        let mut changed = vec![inside(random, along, 0, 0, 99_999)];
        take_leavers(&grid, row * along + column, &mut particles, &mut changed);
        let bin =
            format!("row {row}, column {column} of {along}, a bin with {all} particles from 0 on");
        let which =
            if all < 12 { format!(", of which {:?} have left", &left[1..]) } else { String::new() };
        ask(&format!("{bin}{which}: which stay"), sorted(ids(&particles)), whole(stay));
        let question = format!("{bin}{which}: `changed`, which held 99999 before");
        ask(&question, sorted(ids(&changed)), sorted(whole(left)));
    }
}

/// Lists are cleared and filled again, in any order: the last particle of a bin that came in comes first.
pub(super) fn lists(random: &mut Random, ask: Ask<'_>) {
    let sizes = [random.sizes(4097), vec![70_000]].concat();
    for n in sizes.into_iter().filter(|&n| n > 0) {
        let bins = 1 + random.size(300);
        let mut lists = BinLists::new(bins, n);
        for round in 0..3 {
            lists.clear();
            let mut order: Vec<usize> = (0..n).collect();
            random.shuffle(&mut order);
            order.truncate(random.below(n + 1).max(usize::from(round == 0) * n));
            let mut right = vec![Vec::new(); bins];
            for particle in order {
                let bin = random.below(bins);
                lists.insert(bin, particle);
                right[bin].push(particle);
            }
            for (bin, mut right) in right.into_iter().enumerate() {
                right.reverse();
                let name = format!("round {round} of {n} particles in {bins} bins");
                let found = lists.bin(bin).take(n + 1);
                ask(&format!("{name}: the list of bin {bin}"), whole(found), whole(right.clone()));
                if let Some(at) = (!right.is_empty()).then(|| random.below(right.len())) {
                    let after = lists.after(right[at]).take(n + 1);
                    let question = format!("{name}: those after particle {}", right[at]);
                    ask(&question, whole(after), whole(right[at + 1..].to_vec()));
                }
            }
        }
    }
}

/// The bins that come after one, at walls, in corners and anywhere.
pub(super) fn forwards(random: &mut Random, ask: Ask<'_>) {
    for along in [1, 2, 3, 4, 256, 300, 70_000, 1 << 30] {
        let grid = Grid::with_bins_along(1.0, along);
        for _ in 0..40 {
            let [row, column] =
                [0, 1].map(|_| [0, along - 1, random.below(along)][random.below(3)]);
            let mut bins = [0; 4];
            let count = forward(&grid, row, column, &mut bins).min(4);
            let mut right = Vec::new();
            for (up, to) in
                [(0, column + 1), (1, column.wrapping_sub(1)), (1, column), (1, column + 1)]
            {
                if row + up < along && to < along {
                    right.push((row + up) * along + to);
                }
            }
            let question = format!("the bins after row {row}, column {column} of {along} rows");
            ask(&question, sorted(whole(bins[..count].to_vec())), whole(right));
        }
    }
}

/// In a box of one bin, or of four that all touch, each pair is looked at once.
pub(super) fn looks(random: &mut Random, ask: Ask<'_>) {
    let sizes = random.sizes(4097).into_iter().filter(|&n| n > 0);
    for (n, along) in sizes.flat_map(|n| [(n, 1), (n, 2)]) {
        let all = binned(random, along, &(0..along), n);
        let size = 1.1 * along as f64 * CUTOFF;
        let particles = all.iter().map(|(_, p)| Particle { x: p.x * size, y: p.y * size, ..*p });
        let mut engine = LinkedList::<Count>::new(1.0);
        engine.load(&Scene::new(size, particles.collect()).expect("all are in the box"));
        engine.step();
        let told = engine.statistics().map_or(0, |s| s.pair_tests) as usize;
        let question =
            format!("{n} particles in {along} rows of bins: how many pairs were looked at");
        ask(&question, whole([told]), whole([n * (n - 1) / 2]));
    }
}

/// All or some rows of a grid, sorted again and again, with more and at last with less.
pub(super) fn sorts(random: &mut Random, ask: Ask<'_>) {
    for (along, rows, most) in [
        (1, 0..1, 65_537),
        (7, 0..7, 1025),
        (7, 2..5, 257),
        (2, 1..2, 65_537),
        (300, 0..300, 257),
        (300, 250..300, 4097),
    ] {
        let mut bins = SortedBins::new(Grid::with_bins_along(1.0, along), rows.clone());
        // As they come, and as many in the order of their bins.
        let sizes = random.sizes(most).into_iter().chain([2, 0, 1, 0]);
        for (n, in_order) in sizes.flat_map(|n| [(n, false), (n, true)]) {
            let mut all = binned(random, along, &rows, n);
            if in_order {
                all.sort_by_key(|(bin, _)| *bin);
            }
            bins.refill(all.iter().map(|(_, p)| *p));
            all.sort_by_key(|(bin, _)| *bin);
            let order = if in_order { ", which came in the order of their bins" } else { "" };
            let name = format!("rows {rows:?} of {along} with {n} particles{order}");
            let right = ids(all.iter().map(|(_, p)| p));
            let question =
                format!("{name}, by bin and in a bin as they came: the particles in memory");
            ask(&question, ids(bins.particles()), right);
            for _ in 0..10 {
                let (row, column) = (rows.start + random.below(rows.len()), random.below(along));
                let right = [row * along + column, row * along + column + 1]
                    .map(|end| all.partition_point(|(bin, _)| *bin < end));
                let found = bins.span(row, column..column + 1);
                let question =
                    format!("{name}: where row {row}, column {column} begins and ends in memory");
                ask(&question, whole([found.start, found.end]), whole(right));
            }
        }
    }
}

/// The force on a particle by any number of candidates in several slices, in any order, with ids of any size,
/// many in reach or just at the cutoff; and then by none.
pub(super) fn sums(random: &mut Random, ask: Ask<'_>) {
    let mut gather = Gather::default();
    let sizes: Vec<usize> = (0..12).flat_map(|_| random.sizes(1025)).chain([0]).collect();
    for (case, n) in sizes.into_iter().enumerate() {
        let side = CUTOFF * random.magnitude(0.3, 10.0);
        // The first ids are short.
        let most = if case < 20 { 1 } else { 4 };
        let apart = [1, 1 << 8, 1 << 16, u32::MAX as usize / (n + 1)][random.below(most)];
        let at_the_cutoff = random.below(3) == 0;
        let p = Particle { id: (random.below(n + 1) * apart) as u32, ..Particle::default() };
        let other = |id: usize, random: &mut Random| {
            let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
            let off = [0.0, 1e-15, random.signed(1e-16, 1e-3)][random.below(3)];
            let r = CUTOFF * (1.0 + off);
            let (x, y) = if at_the_cutoff {
                (r * cos, r * sin)
            } else {
                (random.between(-side, side), random.between(-side, side))
            };
            let (x, y) = if (id * apart) as u32 == p.id { (0.0, 0.0) } else { (x, y) };
            Particle { x, y, id: (id * apart) as u32, ..p }
        };
        let mut candidates: Vec<Particle> = (0..n).map(|id| other(id, random)).collect();
        let (mut right, mut near) = (Vec2::ZERO, 0);
        for q in candidates.iter().filter(|q| q.id != p.id) {
            right += acceleration_of_pair(q.x, q.y);
            near += usize::from(p.to(q).norm_squared() <= CUTOFF * CUTOFF);
        }
        random.shuffle(&mut candidates);
        let (some, rest) = candidates.split_at(random.below(n + 1));
        let (more, rest) = rest.split_at(random.below(rest.len() + 1));
        let mut tally = Tally::default();
        let a = gather.acceleration(&p, [&[], some, &[], more, rest], &mut tally);
        let seen = tally.statistics().expect("a tally has statistics");
        let where_to = if at_the_cutoff { "at the cutoff" } else { "near and far" };
        let name = format!("particle {} with {n} candidates {where_to}", p.id);
        let question = format!("{name}: its acceleration, summed in ascending id");
        ask(&question, vec![a.x + 0.0, a.y + 0.0], vec![right.x + 0.0, right.y + 0.0]);
        let question = format!("{name}: candidates looked at, and pairs summed");
        ask(&question, whole([seen.pair_tests as usize, seen.navg as usize]), whole([n, near]));
    }
}
