//! Runs the CSC581 report's MPI program as its section 5.1 prints it, on the report's scene.
//!
//! The program's partition bounds the speed-up, however cheap messages are. Because of its faults,
//! particles are lost and old ghosts remain. All ranks run here one after the other, so counting
//! needs no MPI. Rows lie along x, as in the report.

use std::ops::Range;
use std::process::ExitCode;

use anyhow::Result;
use clap::Parser;
use common::Vec2;
use common::soft::{CUTOFF, DT, Particle, Scene, official_size};
use lab_measure::columns::Columns;
use lab_measure::numbers::Json;
use lab_measure::published::{SOFT_STEPS, scaling};
use oracle::{acceleration_of_pair, fold};
use serde::Serialize;

/// Run the CSC581 report's MPI program as printed: the bounds of its partition, the losses by its
/// faults
#[derive(Parser)]
#[command(name = "reported")]
struct Options {
    #[command(flatten)]
    json: Json,
}

/// Number of particles in total, or for each rank in the weak scaling.
const N: usize = 500;

/// Side of a bin. Bins are not stretched to fill the box.
const BIN: f64 = 2.0 * CUTOFF;

/// The results on a number of ranks.
#[derive(Serialize)]
struct Row {
    ranks: usize,
    rows_each: usize,
    rows_of_the_last: usize,
    /// Largest share of the box that a rank has.
    share: f64,
    speedup_at_most: f64,
    weak_efficiency_at_most: f64,
    /// Speed-up that follows from the share, if messages cost as much as on the report's single
    /// rank.
    speedup_foreseen: f64,
    repaired: Count,
    slip_alone: Count,
    as_printed: Count,
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
struct Count {
    /// Number of particles in the blocks of their ranks after the last step.
    left: usize,
    /// Number of copies outside the blocks after the last step, on all ranks. Only the program as
    /// printed reads these copies.
    ghosts: usize,
    /// Mean number of neighbours of a particle in a step. An old ghost of the particle itself is a
    /// neighbour too.
    neighbours: f64,
    /// Number of pair tests in a step.
    pair_tests: f64,
}

/// Faults of the program that are switched on.
#[derive(Clone, Copy)]
struct Faults {
    /// The program tests `x <= start_bin` instead of `x >= start_bin`.
    slip: bool,
    /// Ghosts are the leavers that the root sent, and they are never removed. Without this fault
    /// ghosts are always right.
    stale: bool,
}

fn main() -> ExitCode {
    lab_kit::command::finish(run(&Options::parse()))
}

fn run(options: &Options) -> Result<ExitCode> {
    let scene = Scene::official(N as u64, 1)?;
    let rows: Vec<Row> = [1, 2, 4, 8, 16].map(|ranks| Row::new(&scene, ranks)).into();
    let table = Columns::of("ranks", |row: &Row| row.ranks.to_string())
        .text("rows each", |row| row.rows_each.to_string())
        .text("of the last", |row| row.rows_of_the_last.to_string())
        .number("speed-up at most", |row| Some(row.speedup_at_most))
        .number("with messages", |row| Some(row.speedup_foreseen))
        .number("weak eff. at most", |row| Some(row.weak_efficiency_at_most))
        .text("left, slip alone", |row| row.slip_alone.left.to_string())
        .text("as printed", |row| row.as_printed.left.to_string())
        .text("ghosts", |row| row.as_printed.ghosts.to_string())
        .number("neighbours", |row| Some(row.as_printed.neighbours))
        .number("repaired", |row| Some(row.repaired.neighbours))
        .number("pair tests", |row| Some(row.as_printed.pair_tests))
        .number("repaired", |row| Some(row.repaired.pair_tests));
    println!("{}", table.table(&rows));
    options.json.write_by("cargo run --release -p halo --example reported --", &rows)?;
    Ok(ExitCode::SUCCESS)
}

impl Row {
    fn new(scene: &Scene, ranks: usize) -> Self {
        let share = share(N, ranks);
        let along = along(scene.size());
        let of_messages = 1.0 / scaling("csc581-mpi").speedups()[0] - 1.0;
        Self {
            ranks,
            rows_each: along / ranks,
            rows_of_the_last: block(along, ranks, ranks - 1).len(),
            share,
            speedup_at_most: 1.0 / share,
            weak_efficiency_at_most: 1.0 / (ranks as f64 * self::share(N * ranks, ranks)),
            speedup_foreseen: 1.0 / (share + of_messages),
            repaired: count(scene, ranks, Faults { slip: false, stale: false }),
            slip_alone: count(scene, ranks, Faults { slip: true, stale: false }),
            as_printed: count(scene, ranks, Faults { slip: true, stale: true }),
        }
    }
}

/// Returns the number of rows of bins in a box of this side. Each row has as many bins as there are
/// rows.
fn along(size: f64) -> usize {
    (size / BIN) as usize + 1
}

/// Returns the rows of a rank: `along / ranks`, and for the last rank also the remainder.
fn block(along: usize, ranks: usize, rank: usize) -> Range<usize> {
    let each = along / ranks;
    rank * each..if rank + 1 == ranks { along } else { (rank + 1) * each }
}

/// Returns the largest share of the box of `n` particles that one of `ranks` ranks has.
fn share(n: usize, ranks: usize) -> f64 {
    let size = official_size(n);
    let mut largest: f64 = 0.0;
    for rank in 0..ranks {
        let rows = block(along(size), ranks, rank);
        let width = (rows.end as f64 * BIN).min(size) - rows.start as f64 * BIN;
        largest = largest.max(width / size);
    }
    largest
}

/// Runs all steps and returns the counts.
fn count(scene: &Scene, ranks: usize, faults: Faults) -> Count {
    let mut job = Job::new(scene, ranks, faults);
    (0..SOFT_STEPS as usize).for_each(|_| job.step());
    let all = job.bins.iter().flatten().map(Vec::len).sum::<usize>();
    let left = job.own().count();
    let Counted { moves, neighbours, pair_tests } = job.counted;
    Count {
        left,
        ghosts: all - left,
        neighbours: neighbours as f64 / moves as f64,
        pair_tests: pair_tests as f64 / SOFT_STEPS,
    }
}

/// Sums over all steps and ranks.
#[derive(Clone, Copy, Default)]
struct Counted {
    moves: usize,
    neighbours: usize,
    pair_tests: usize,
}

/// The state of all ranks.
struct Job {
    faults: Faults,
    size: f64,
    along: usize,
    /// The bins of the whole box, for each rank.
    bins: Vec<Vec<Vec<Particle>>>,
    counted: Counted,
}

/// Particles that have left their bins.
#[derive(Default)]
struct Leavers {
    /// Particles that stay in the rank's block.
    local: Vec<Particle>,
    remote: Vec<Particle>,
}

impl Job {
    /// Gives all particles to every rank. Each rank puts them into its bins.
    fn new(scene: &Scene, ranks: usize, faults: Faults) -> Self {
        let along = along(scene.size());
        let mut bins = vec![Vec::new(); along * along];
        for particle in scene.particles() {
            let (row, column) = place(particle);
            bins[row * along + column].push(*particle);
        }
        let bins = vec![bins; ranks];
        Self { faults, size: scene.size(), along, bins, counted: Counted::default() }
    }

    fn put(&mut self, rank: usize, particle: Particle) {
        let (row, column) = place(&particle);
        self.bins[rank][row * self.along + column].push(particle);
    }

    /// Returns the numbers of the bins in a rank's own block.
    fn own_bins(&self, rank: usize) -> Range<usize> {
        let Range { start, end } = block(self.along, self.bins.len(), rank);
        start * self.along..end * self.along
    }

    /// Iterates over the particles in the blocks of their ranks.
    fn own(&self) -> impl Iterator<Item = &Particle> {
        let bins = self.bins.iter().enumerate();
        bins.flat_map(|(rank, bins)| &bins[self.own_bins(rank)]).flatten()
    }

    /// Returns the rank that has a row.
    fn owner(&self, row: usize) -> usize {
        (row / (self.along / self.bins.len())).min(self.bins.len() - 1)
    }

    fn step(&mut self) {
        let ranks = 0..self.bins.len();
        let accelerations: Vec<_> = ranks.map(|rank| self.accelerations(rank)).collect();
        let mut all_remote = Vec::new();
        for (rank, accelerations) in accelerations.iter().enumerate() {
            let Leavers { local, remote } = self.move_particles(rank, accelerations);
            local.into_iter().for_each(|particle| self.put(rank, particle));
            all_remote.extend(remote);
        }
        self.send_through_root(&all_remote);
    }

    /// Computes the accelerations of a rank's own particles, bin by bin.
    fn accelerations(&mut self, rank: usize) -> Vec<Vec2> {
        let mut all = Vec::new();
        let mut counted = self.counted;
        for bin in self.own_bins(rank) {
            let others = self.around(rank, bin);
            for particle in &self.bins[rank][bin] {
                let mut a = Vec2::ZERO;
                for d in others.iter().map(|other| particle.to(other)) {
                    let is_near = d != Vec2::ZERO && d.norm_squared() <= CUTOFF * CUTOFF;
                    a += acceleration_of_pair(d.x, d.y);
                    counted.neighbours += usize::from(is_near);
                }
                all.push(a);
                counted.moves += 1;
                counted.pair_tests += others.len();
            }
        }
        self.counted = counted;
        all
    }

    /// Returns the particles in and around a bin of a rank's own block.
    fn around(&self, rank: usize, bin: usize) -> Vec<&Particle> {
        let [rows, columns] = [bin / self.along, bin % self.along]
            .map(|at| at.saturating_sub(1)..(at + 2).min(self.along));
        let mut others = Vec::new();
        for row in rows {
            let seen = if self.faults.stale { rank } else { self.owner(row) };
            for column in columns.clone() {
                others.extend(&self.bins[seen][row * self.along + column]);
            }
        }
        others
    }

    /// Moves a rank's own particles and takes the leavers out of their bins.
    fn move_particles(&mut self, rank: usize, accelerations: &[Vec2]) -> Leavers {
        let rows = block(self.along, self.bins.len(), rank);
        let mut leavers = Leavers::default();
        let mut accelerations = accelerations.iter();
        for number in self.own_bins(rank) {
            let bin = &mut self.bins[rank][number];
            for (particle, a) in bin.iter_mut().zip(&mut accelerations) {
                advance(particle, *a, self.size);
            }
            let mut i = 0;
            while i < bin.len() {
                let (x, y) = place(&bin[i]);
                let begins = if self.faults.slip { x <= rows.start } else { x >= rows.start };
                let stays = begins && x < rows.end;
                if stays && x * self.along + y == number {
                    i += 1;
                    continue;
                }
                let leaver = bin.swap_remove(i);
                if stays { &mut leavers.local } else { &mut leavers.remote }.push(leaver);
            }
        }
        leavers
    }

    /// Sends each particle to the owner of its row.
    ///
    /// If the row counts as a border row, the particle also goes to the rank beyond as a ghost.
    fn send_through_root(&mut self, remote: &[Particle]) {
        let last = self.bins.len() - 1;
        let each = self.along / self.bins.len();
        for particle in remote {
            let row = place(particle).0;
            let owner = self.owner(row);
            self.put(owner, *particle);
            if row.is_multiple_of(each) && owner != 0 {
                self.put(owner - 1, *particle);
            }
            if row % each == each - 1 && owner != last {
                self.put(owner + 1, *particle);
            }
        }
    }
}

/// Returns the row and the column of a particle's bin.
fn place(particle: &Particle) -> (usize, usize) {
    ((particle.x / BIN) as usize, (particle.y / BIN) as usize)
}

fn advance(particle: &mut Particle, a: Vec2, size: f64) {
    particle.vx += a.x * DT;
    particle.vy += a.y * DT;
    (particle.x, particle.vx) = fold(particle.x + particle.vx * DT, particle.vx, size);
    (particle.y, particle.vy) = fold(particle.y + particle.vy * DT, particle.vy, size);
}

#[cfg(test)]
mod tests {
    use oracle::Model;

    use super::*;

    #[test]
    fn repaired_it_is_the_model_and_the_slip_loses_particles() {
        let scene = Scene::official(N as u64, 1).expect("500 particles are a scene");
        let mut job = Job::new(&scene, 4, Faults { slip: false, stale: false });
        let mut model = Model::new(&scene);
        for _ in 0..100 {
            job.step();
            model.step();
        }
        assert_eq!(job.own().count(), N);
        for particle in job.own() {
            let off = particle.to(&model.particles[particle.id as usize]);
            assert!(off.norm_squared() < 1e-18, "{particle:?}");
        }
        assert_eq!(count(&scene, 4, Faults { slip: true, stale: false }).left, 265);
        assert_eq!(block(26, 16, 14), 14..15);
        assert_eq!(block(26, 16, 15), 15..26);
    }
}
