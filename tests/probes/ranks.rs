//! A probe on several ranks: the program starts itself again under `mpiexec`.
//!
//! It comes here before any code of the lab has run. In a sandbox there is neither a home folder nor
//! room for shared files, so Open MPI is told to use the loopback network for everything.

use std::env;
use std::process::{ExitCode, exit};

use common::soft::CUTOFF;
use common_mpi::as_rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::{Answers, Random};

#[path = "mpiexec.rs"]
mod mpiexec;

/// Says to a program that it is a rank of a job.
const RANK_OF: &str = "PROBE_RANK_OF";

/// What Open MPI needs to run without shared files and without spinning, and to end a job that hangs; and a watch,
/// which does not let a rank leave out a collective operation because it has nothing to send.
const OPEN_MPI: [(&str, &str); 8] = [
    ("MPIEXEC_TIMEOUT", "20"),
    ("PMIX_MCA_gds", "hash"),
    ("OMPI_MCA_pml", "ob1"),
    ("OMPI_MCA_btl", "self,tcp"),
    ("OMPI_MCA_btl_tcp_if_include", "lo"),
    ("OMPI_MCA_mpi_yield_when_idle", "1"),
    ("OMPI_MCA_osc", "^ucx"),
    ("CUTOFF_WATCH", "18"),
];

/// Numbers of ranks to ask on: few, and one that nobody knows.
pub fn counts(random: &mut Random) -> [usize; 4] {
    [1, 2, 3, 4 + random.below(3)]
}

/// The side of a box whose rows of bins of one cutoff are as many for each rank, some 12 to 24 in all.
pub fn even_side(random: &mut Random, ranks: usize) -> f64 {
    ((ranks * (12 / ranks + random.below(3))) as f64 + 0.5) * CUTOFF
}

/// Brings the numbers of all ranks to the root, which tells them, rank by rank.
pub fn tell_all(world: &SimpleCommunicator, answers: &mut Answers, question: &str, own: &[f64]) {
    let root = world.process_at_rank(0);
    if world.rank() == 0 {
        let mut all = vec![0.0; own.len() * world.size() as usize];
        root.gather_into_root(own, &mut all[..]);
        answers.exact(question, &all);
    } else {
        root.gather_into(own);
    }
}

/// For questions that tests ask too, on each rank: what is right is the solution's to say here.
pub fn on_all(
    world: &SimpleCommunicator,
    answers: &mut Answers,
) -> impl FnMut(&str, Vec<f64>, Vec<f64>) {
    |question, found, _| tell_all(world, answers, question, &found)
}

/// Runs `program` on all ranks of a job, for each of these numbers of ranks in turn.
///
/// # Panics
/// A job failed.
pub fn each(counts: &[usize], program: impl FnOnce(&SimpleCommunicator)) {
    if env::var_os(RANK_OF).is_some() {
        let code = as_rank(|world| {
            program(world);
            ExitCode::SUCCESS
        });
        // The launcher's program has the last word.
        exit(i32::from(code != ExitCode::SUCCESS));
    }
    for ranks in counts {
        let mut launcher = mpiexec::itself_on(*ranks);
        launcher.env(RANK_OF, ranks.to_string()).envs(OPEN_MPI);
        let ended = launcher.status().expect("mpiexec starts");
        assert!(ended.success(), "on {ranks} ranks the job failed, or some rank waited for ever");
    }
}
