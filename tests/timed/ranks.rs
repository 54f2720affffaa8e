//! A team of ranks: the program starts itself again under `mpiexec`, before any code of the lab has
//! run, and no rank talks to the grader before all are there.

use std::env;
use std::process::ExitCode;

use common_mpi::as_rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Says to a program that it is a rank of a job.
const RANK_OF: &str = "TIMED_RANK_OF";

/// What Open MPI needs to run without a home, and to leave a processor to a rank that has work. Messages
/// go through shared memory.
const OPEN_MPI: [(&str, &str); 4] = [
    ("PMIX_MCA_gds", "hash"),
    ("OMPI_MCA_pml", "ob1"),
    ("OMPI_MCA_osc", "^ucx"),
    ("OMPI_MCA_mpi_yield_when_idle", "1"),
];

/// What the other ranks print would stand in the middle of what the first one sends.
const SILENT: &str = "exec \"$0\" \"$@\" >/dev/null";

/// What carries out an order: one process, or the ranks of a job.
pub struct Team<'a>(&'a SimpleCommunicator);

impl Team<'_> {
    /// Whether this process talks to the grader.
    pub fn is_first(&self) -> bool {
        self.0.rank() == 0
    }

    /// What the first was told, told to all.
    pub fn share(&self, told: String) -> String {
        let (root, mut bytes) = (self.0.process_at_rank(0), told.into_bytes());
        let mut length = bytes.len() as u64;
        root.broadcast_into(&mut length);
        bytes.resize(length as usize, 0);
        root.broadcast_into(&mut bytes[..]);
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

/// Brings the team together and has it do its work.
///
/// # Panics
/// There is no `mpiexec`.
pub fn gather(workers: usize, work: impl FnOnce(&Team<'_>) -> ExitCode) -> ExitCode {
    if env::var_os(RANK_OF).is_some() {
        return as_rank(|world| {
            world.barrier();
            work(&Team(world))
        });
    }
    let mut launcher = oracle::itself_on(1);
    if workers > 1 {
        let itself = env::current_exe().expect("a program knows its own path");
        launcher.args([":", "-n", &(workers - 1).to_string(), "/bin/sh", "-c", SILENT]);
        launcher.arg(itself).args(env::args().skip(1));
    }
    launcher.env(RANK_OF, workers.to_string()).envs(OPEN_MPI);
    let ended = launcher.status().expect("mpiexec starts");
    if ended.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
