//! What is asked about lab 2.
//!
//! Each task's own function is asked, in grids whose size is given and with particles that the
//! probe has put where they belong: a mistake in one task costs that task.

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Particle, Scene, official_size};
use lab2::{BIN_SIZE, BinLists, Gather, Grid, SortedBins, VARIANTS, VecBins, forward};

use self::questions::inside;
use self::soft::{Count, Engine};
use crate::{Answers, Random, truth};

#[path = "../lab2/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "2.1" => grids(random, answers),
        "2.2" => near(random, answers),
        "2.3" => refills(random, answers),
        "2.4" => nine_bins(random, answers),
        "2.5" => questions::leavers(random, &mut told(answers)),
        "2.6" => {
            questions::lists(random, &mut told(answers));
            long_lists(answers);
        }
        "2.7" => every_pair_once(random, answers),
        "2.8" => counting_sort(random, answers),
        "2.9" => sums(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// Tells what the lab answers; what is right is the solution's to say.
fn told(answers: &mut Answers) -> impl FnMut(&str, Vec<usize>, Vec<usize>) {
    |question, found, _| {
        let found: Vec<f64> = found.into_iter().map(|number| number as f64).collect();
        answers.exact(question, &found);
    }
}

fn grids(random: &mut Random, answers: &mut Answers) {
    let mut ask = |size: f64, least: f64, n: usize| {
        let grid = Grid::new(size, least * CUTOFF, n);
        let question = format!(
            "bins along a wall of {:.3e} cutoffs, of {least:.2} cutoffs or more, for {n}",
            size / CUTOFF
        );
        answers.exact(&question, &[grid.rows() as f64]);
    };
    for _ in 0..300 {
        ask(random.between(0.2, 200.0) * CUTOFF, random.between(1.0, 3.0), 1_000_000);
        // Walls that a whole number of bins fills are where rounding bites.
        ask(random.below(200) as f64 * CUTOFF + CUTOFF, 1.0, 1_000_000);
    }
    for size in [1e30, 1e300, random.between(1e3, 1e9)] {
        ask(size, 1.0, 1 + random.below(100_000));
    }
    ask(official_size(100_000), 1.0, 100_000);
    for _ in 0..300 {
        let along = 1 + random.below(300);
        let size = random.between(0.3, 300.0) * CUTOFF;
        let grid = Grid::with_bins_along(size, along);
        let inside = (random.below(along) as f64 + random.between(0.1, 0.9)) * size / along as f64;
        for x in [0.0, inside, size, size.next_down(), size.next_down().next_down()] {
            let question = format!("column of x = {x:?} among {along} in a box of {size:?}");
            answers.exact(&question, &[grid.column(x) as f64]);
        }
    }
    let many = Grid::with_bins_along(1.0, 100_000);
    let columns = [0.3, 0.7, 1.0].map(|x| many.column(x + 1e-7) as f64);
    answers.exact("the columns of x = 0.3, 0.7 and 1 among 100,000", &columns);
}

fn near(random: &mut Random, answers: &mut Answers) {
    for along in [1, 2, 3, 4, 5 + random.below(100)] {
        let grid = Grid::with_bins_along(1.0, along);
        for index in 0..along {
            let near = grid.near(index);
            let question = format!("the rows next to row {index} of {along}, first and last + 1");
            answers.exact(&question, &[near.start as f64, near.end as f64]);
        }
    }
}

/// `n` particles well inside bins, numbered.
fn all_inside(random: &mut Random, along: usize, n: usize) -> Vec<Particle> {
    let particle = |id| {
        let (row, column) = (random.below(along), random.below(along));
        inside(random, along, row, column, id)
    };
    (0..n).map(particle).collect()
}

fn ids(particles: &[Particle]) -> Vec<f64> {
    particles.iter().map(|p| f64::from(p.id)).collect()
}

fn refills(random: &mut Random, answers: &mut Answers) {
    const ALONG: usize = 5;
    let mut bins = VecBins::new(Grid::with_bins_along(1.0, ALONG));
    for refill in 1..=250 {
        let n = [40, 25, 0, 3, 70][refill % 5];
        let mut particles = all_inside(random, ALONG, n);
        if refill % 10 == 0 {
            // A crowd in one bin.
            particles.extend((0..n).map(|k| inside(random, ALONG, 1, 3, n + k)));
        }
        bins.refill(&particles);
        for (bin, inside) in bins.bins().iter().enumerate() {
            let (row, column) = (bin / ALONG, bin % ALONG);
            let question = format!("refill {refill}, particles in row {row}, column {column}");
            answers.exact(&question, &soft::ids(inside));
        }
    }
    let mut bins = VecBins::new(Grid::with_bins_along(1.0, ALONG));
    for id in 0..100 {
        let (row, column) = (random.below(ALONG), random.below(ALONG));
        bins.put(inside(random, ALONG, row, column, id));
        let inside = soft::ids(&bins.bins()[row * ALONG + column]);
        let question =
            format!("particles in row {row}, column {column} after particle {id} was put");
        answers.exact(&question, &inside);
    }
}

/// The sum of magnitudes of what all particles do to one: what rounding is relative to.
fn magnitude(particle: &Particle, all: &[Particle]) -> f64 {
    let a = all.iter().filter_map(|other| solution1::pair_acceleration(particle.to(other)));
    1.0 + a.map(|a| a.norm_squared().sqrt()).sum::<f64>()
}

/// Bins of a given grid with each particle in its bin, whatever the submission puts there.
fn filled(grid: Grid, particles: &[Particle]) -> VecBins {
    let mut bins = VecBins::new(grid);
    let along = grid.columns();
    for p in particles {
        let at = |x: f64| place(x, grid.size(), along);
        bins.bins_mut()[at(p.y) * along + at(p.x)].push(*p);
    }
    bins
}

/// The row or column of a place.
fn place(x: f64, size: f64, along: usize) -> usize {
    ((x / size * along as f64) as usize).min(along - 1)
}

/// Beyond the nine bins around a particle the others are nowhere: whoever looks at them finds no force.
fn nine_bins(random: &mut Random, answers: &mut Answers) {
    for (along, n) in [(1, 20), (2, 40), (3, 60), (7, 150), (12, 400)] {
        let size = 1.02 * along as f64 * CUTOFF;
        let scene = soft::crowd(random, n, size, 0.0);
        let grid = Grid::with_bins_along(size, along);
        for p in scene.particles() {
            let mut bins = filled(grid, scene.particles());
            let mut around = 0;
            for (bin, inside) in bins.bins_mut().iter_mut().enumerate() {
                let rows = (bin / along).abs_diff(place(p.y, size, along));
                let columns = (bin % along).abs_diff(place(p.x, size, along));
                if rows.max(columns) <= 1 {
                    around += inside.len() as u64;
                } else {
                    inside.iter_mut().for_each(|q| (q.x, q.y) = (f64::NAN, f64::NAN));
                }
            }
            let mut count = Count::default();
            let a = bins.acceleration(p, &mut count);
            let scale = magnitude(p, scene.particles());
            let place = format!(
                "particle {} at ({:.4}, {:.4}) cutoffs in {along} rows of bins",
                p.id,
                p.x / CUTOFF,
                p.y / CUTOFF
            );
            let question = format!("the force on {place}, by the sum of its parts' sizes");
            answers.close(&question, &[a.x / scale, a.y / scale]);
            // The particle itself may count or not.
            let told = count.tested == around || count.tested + 1 == around;
            let question = format!(
                "whether all {around} in the bins around {place} are counted, and no others"
            );
            answers.exact(&question, &[truth(told)]);
        }
    }
}

/// In a box with more of them than 16 bits can number.
fn long_lists(answers: &mut Answers) {
    let mut lists = BinLists::new(2, 70_000);
    for particle in [3, 66_000, 300] {
        lists.insert(1, particle);
    }
    let found: Vec<f64> = lists.bin(1).take(50).map(|p| p as f64).collect();
    answers.exact("a list of particles with numbers up to 66,000", &found);
}

/// The forces need whole steps. Bins are two and three cutoffs wide: a grid with bins somewhat
/// too narrow still finds every pair.
fn every_pair_once(random: &mut Random, answers: &mut Answers) {
    for along in [1, 2, 3, 4, 5 + random.below(4)] {
        let grid = Grid::with_bins_along(1.0, along);
        for (row, column) in (0..along * along).map(|bin| (bin / along, bin % along)) {
            let mut bins = [0; 4];
            let count = forward(&grid, row, column, &mut bins).min(4);
            bins[..count].sort_unstable();
            let values: Vec<f64> = bins[..count].iter().map(|bin| *bin as f64).collect();
            let question = format!("the bins after row {row}, column {column} of {along} rows");
            answers.exact(&question, &values);
        }
    }
    for bin_size in [2.0, 3.0] {
        let mut engine = Engine::new(VARIANTS, "linked-list", 1, &[(BIN_SIZE, bin_size)]);
        let mut ask = |name: &str, scene: &Scene, steps| {
            let question = format!("linked-list, bins of {bin_size} cutoffs, {name}");
            answers.steps(&question, &engine.run(scene, steps));
        };
        ask("150 in 10.3 cutoffs", &soft::spread(random, 150, 10.3 * CUTOFF, 1.0), 15);
        ask("a heap of 60", &soft::heap(random), 2);
        ask("a crowd of 150", &soft::crowd(random, 150, 6.9 * CUTOFF, 1.0), 2);
        ask("pairs over edges", &soft::pairs_over_edges(random), 1);
    }
    let mut engine = Engine::counting(VARIANTS, "linked-list", 1, &[(BIN_SIZE, 2.0)]);
    let scene = soft::spread(random, 300, 15.3 * CUTOFF, 1.0);
    for statistics in engine.statistics(&scene, 1) {
        answers.close("dmin, davg, navg of 300 particles", &statistics[..3]);
    }
}

fn counting_sort(random: &mut Random, answers: &mut Answers) {
    const ALONG: usize = 7;
    for (first, last) in [(0, ALONG), (2, 5), (3, 4)] {
        let mut bins = SortedBins::new(Grid::with_bins_along(1.0, ALONG), first..last);
        for round in 0..30 {
            let n = [0, 1, 90, 20, 91][round % 5];
            let mut particles = all_inside(random, ALONG, n);
            particles.retain(|p| (first..last).contains(&((p.y * ALONG as f64) as usize)));
            bins.refill(particles);
            for (row, column) in (first..last).flat_map(|row| (0..ALONG).map(move |c| (row, c))) {
                let question =
                    format!("rows {first} to {last}, sort {round}, row {row}, column {column}");
                answers.exact(&question, &ids(bins.bin(row, column)));
            }
            answers.exact("all of them, in the order of memory", &ids(bins.particles()));
        }
    }
    let mut bins = SortedBins::new(Grid::with_bins_along(1.0, 2), 0..2);
    bins.refill(all_inside(random, 2, 70_000));
    let sizes = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(row, column)| {
        let inside = bins.bin(row, column).iter();
        inside.filter(|p| (p.y >= 0.5, p.x >= 0.5) == (row == 1, column == 1)).count() as f64
    });
    answers.exact("how many of 70,000 particles each of four bins has, of its own", &sizes);
}

fn sums(random: &mut Random, answers: &mut Answers) {
    let mut gather = Gather::default();
    for case in 0..600 {
        let n = if case % 60 == 59 { 400 } else { [30, 2, 12, 60][case % 4] };
        // Of so many all are in reach.
        let side = if n == 400 { 0.7 * CUTOFF } else { 1.7 * CUTOFF };
        let scene = soft::crowd(random, n, side, 0.0);
        let mut candidates = scene.particles().to_vec();
        // Numbers that differ in their upper bits only, too.
        let apart = [1, 1 << 8, 1 << 16, u32::MAX / n as u32][case / 4 % 4];
        candidates.iter_mut().for_each(|p| p.id *= apart);
        let p = candidates[random.below(n)];
        random.shuffle(&mut candidates);
        let (some, rest) = candidates.split_at(random.below(n + 1));
        let mut count = Count::default();
        let a: Vec2 = gather.acceleration(&p, [some, &[], rest], &mut count);
        let question = format!("the force on particle {} of a crowd of {n}, to the bit", p.id);
        answers.exact(&question, &[a.x, a.y]);
        answers.exact("how many candidates the observer was told of", &[count.tested as f64]);
    }
    let alone = Particle { x: 0.5, y: 0.5, id: 3, ..Particle::default() };
    let far = Particle { x: 0.5 + 1.001 * CUTOFF, id: 1, ..alone };
    let a = gather.acceleration(&alone, [&[far, alone][..]], &mut NoStatistics);
    answers.exact("the force on a particle with none in reach", &[a.x, a.y]);
}
