//! The messages of one step of the dozen particles of chapters 5 and 6, two rows to a rank.

use common::soft::Particle;
use common_mpi::Wire;
use lab6::{Cuts, exchange_all, exchange_beside, interior_rows, sort_leavers};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::{Ask, Random, scenes, spaced};
use oracle_mpi::on_each;
use solution2::Grid;

pub(crate) fn one_step(random: &mut Random, ask: &mut impl Ask) {
    on_each(ask, "6.6", &[3], random, |rank, _, ask| {
        let rows = rank.call("a step", |world| Step::new(world).rows());
        let table = rank.columns(&rows);
        if rank.is_root() {
            ask.example(|| table);
        }
    });
}

/// The step of one rank, with its record.
struct Step<'a> {
    world: &'a SimpleCommunicator,
    grid: Grid,
    cuts: Cuts,
    rank: usize,
    /// Particles of the rank before the step.
    own: Vec<Particle>,
    rows: Vec<(&'static str, String)>,
}

/// A list for the rank before and a list for the rank after, with the names of their rows.
type Lists = [(&'static str, Vec<Wire>); 2];

impl<'a> Step<'a> {
    fn new(world: &'a SimpleCommunicator) -> Self {
        let grid = Grid::with_bins_along(6.0, 6);
        let cuts = Cuts { starts: vec![0, 2, 4, 6] };
        let rank = world.rank() as usize;
        let [before, _] = scenes::dozen();
        let own: Vec<Particle> =
            before.into_iter().filter(|p| cuts.owner(grid.row(p.y)) == rank).collect();
        let rows = vec![("own particles", ids(&own))];
        Self { world, grid, cuts, rank, own, rows }
    }

    /// Returns the rows of this rank's column.
    fn rows(mut self) -> Vec<(&'static str, String)> {
        let [_, after] = scenes::dozen();
        let moved: Vec<Particle> = self.own.iter().map(|p| after[p.id as usize]).collect();
        let is_out = |p: &&Particle| self.cuts.owner(self.grid.row(p.y)) != self.rank;
        let out: Vec<Wire> = moved.iter().filter(is_out).map(Wire::from).collect();
        // Calls this task's function first, so that an unsolved starter stops at this task's
        // `todo!`.
        let sorted = sort_leavers(&self.grid, &self.cuts, self.neighbours(), &out);
        self.exchange_ghosts();
        self.note("moved; out of the block", ids_of(&out));
        let [before, after] = sorted.near;
        let movers = [("movers to the rank before", before), ("movers to the rank after", after)];
        let (arrived, ()) = self.both_ways(movers, || ());
        self.note("movers from both", arrived);
        self.exchange_far(sorted.far);
        self.rows
    }

    /// Sums forces on the particles of interior rows while ghosts travel, and on the others when
    /// the ghosts have arrived.
    fn exchange_ghosts(&mut self) {
        let first = 2 * self.rank;
        let interior = interior_rows(&(first..first + 2), 6);
        let is_inside = |p: &&Particle| interior.contains(&self.grid.row(p.y));
        let meanwhile = ids(self.own.iter().filter(is_inside));
        let later = ids(self.own.iter().filter(|p| !is_inside(p)));
        let ghosts = [
            ("ghosts to the rank before", self.row(first)),
            ("ghosts to the rank after", self.row(first + 1)),
        ];
        let (arrived, meanwhile) = self.both_ways(ghosts, || meanwhile);
        self.note("meanwhile, forces on", meanwhile);
        self.note("ghosts from both", arrived);
        self.note("then forces on", later);
    }

    fn exchange_far(&mut self, far: Vec<(usize, Wire)>) {
        let own = far.len() as u64;
        let mut all = 0;
        self.world.all_reduce_into(&own, &mut all, SystemOperation::sum());
        self.note("count of far movers", own.to_string());
        self.note("  count of all ranks", all.to_string());
        let mut lists = vec![Vec::new(); 3];
        far.into_iter().for_each(|(to, wire)| lists[to].push(wire));
        let arrived = exchange_all(self.world, &lists);
        self.note("  after Alltoallv", ids_of(&arrived));
    }

    /// Sends the lists to the ranks before and after, where they exist, and records them. Returns
    /// the ids of the received particles and the result of `work`.
    fn both_ways<R>(&mut self, lists: Lists, work: impl FnOnce() -> R) -> (String, R) {
        let mut outgoing = Vec::new();
        for (neighbour, (name, list)) in self.neighbours().into_iter().zip(lists) {
            self.note(name, neighbour.map_or_else(String::new, |_| ids_of(&list)));
            outgoing.extend(neighbour.map(|rank| (rank as i32, list)));
        }
        let (incoming, worked) = exchange_beside(self.world, &outgoing, work);
        (ids_of(incoming.iter().flatten()), worked)
    }

    fn neighbours(&self) -> [Option<usize>; 2] {
        [self.rank.checked_sub(1), Some(self.rank + 1).filter(|rank| *rank < 3)]
    }

    /// Returns the rank's own particles in a row.
    fn row(&self, row: usize) -> Vec<Wire> {
        self.own.iter().filter(|p| self.grid.row(p.y) == row).map(Wire::from).collect()
    }

    fn note(&mut self, name: &'static str, cell: String) {
        self.rows.push((name, cell));
    }
}

fn ids<'a>(particles: impl IntoIterator<Item = &'a Particle>) -> String {
    spaced(particles.into_iter().map(|p| p.id))
}

fn ids_of<'a>(wires: impl IntoIterator<Item = &'a Wire>) -> String {
    spaced(wires.into_iter().map(|wire| wire.id))
}
