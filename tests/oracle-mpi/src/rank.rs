//! One rank of a job, or its substitute if there is no job.

use std::process::ExitCode;

use common_mpi::{as_rank, together};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use oracle::{Ask, Columns, Random, memory};

/// A rank that answers questions.
pub struct Rank<'a> {
    /// Number of the rank, from 0.
    pub number: usize,
    /// Number of ranks of the job.
    pub ranks: usize,
    world: Option<&'a SimpleCommunicator>,
}

/// Makes every rank ask `part`, in a job on each of these numbers of ranks. All ranks draw the same
/// random numbers.
pub fn on_each<A: Ask>(
    ask: &mut A,
    task: &str,
    counts: &[usize],
    random: &Random,
    part: impl Fn(&Rank<'_>, &mut Random, &mut A),
) {
    let on_this_rank = |ask: &mut A| {
        as_rank(|world| {
            let (number, ranks) = (world.rank() as usize, world.size() as usize);
            part(&Rank { number, ranks, world: Some(world) }, &mut random.clone(), ask);
            ExitCode::SUCCESS
        });
    };
    let of_rank = |number: usize, ranks: usize, ask: &mut A| {
        part(&Rank { number, ranks, world: None }, &mut random.clone(), ask);
    };
    ask.on_ranks(task, counts, on_this_rank, of_rank);
}

impl Rank<'_> {
    /// Returns whether the rank is the root, rank 0.
    pub fn is_root(&self) -> bool {
        self.number == 0
    }

    /// Names the rank: `rank 1 of 3`.
    pub fn name(&self) -> String {
        format!("rank {} of {}", self.number, self.ranks)
    }

    /// Returns the communicator of all ranks. Only the closures of answers may call this function.
    ///
    /// # Panics
    /// If there is no job.
    pub fn world(&self) -> &SimpleCommunicator {
        self.world.expect("answers are asked for in a job")
    }

    /// Makes a call that all ranks make. Without a job it returns the default. `what` names the
    /// call for the watch.
    pub fn call<T: Default>(&self, what: &str, call: impl FnOnce(&SimpleCommunicator) -> T) -> T {
        self.world.map_or_else(T::default, |world| together(what, || call(world)))
    }

    /// Asks whether the memory of this rank grows with the turns that all ranks take together. Each
    /// turn handles `bytes` bytes.
    pub fn keeps_its_memory(
        &self,
        what: &str,
        bytes: usize,
        mut turn: impl FnMut(&SimpleCommunicator),
        ask: &mut impl Ask,
    ) {
        let turns = |turns| {
            for _ in 0..turns {
                self.call(what, &mut turn);
                self.world().barrier();
            }
        };
        memory(&format!("{what} on {}", self.name()), (50, bytes), turns, ask);
    }

    /// Returns a table with a column for each rank. On ranks other than the root and without a job,
    /// returns an empty text. `rows` contains the names and this rank's cells. All ranks must pass
    /// the same names.
    pub fn columns(&self, rows: &[(&str, String)]) -> String {
        let Some(world) = self.world else { return String::new() };
        let mut table = Columns::new((0..self.ranks).map(|rank| format!("rank {rank}")));
        for (name, cell) in rows {
            table.row(*name, gathered(world, cell));
        }
        if self.is_root() { table.to_string() } else { String::new() }
    }
}

/// Gathers the texts of all ranks on the root.
fn gathered(world: &SimpleCommunicator, text: &str) -> Vec<String> {
    // This width is enough for a cell of a table.
    const WIDTH: usize = 200;
    let mut own = text.as_bytes().to_vec();
    own.resize(WIDTH, 0);
    let root = world.process_at_rank(0);
    if world.rank() > 0 {
        root.gather_into(&own[..]);
        return Vec::new();
    }
    let mut all = vec![0; WIDTH * world.size() as usize];
    root.gather_into_root(&own[..], &mut all[..]);
    let cell = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim_end_matches('\0').to_owned();
    all.chunks(WIDTH).map(cell).collect()
}
