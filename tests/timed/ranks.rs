//! A team of ranks. The program starts itself again under `mpiexec` before any code of the lab has
//! run. Ranks do not communicate with the grader before all ranks are ready.

use std::env;
use std::process::ExitCode;

use common_mpi::as_rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Variable that marks a program as a rank of a job.
const RANK_OF: &str = "TIMED_RANK_OF";

/// Settings that let Open MPI run without a home folder, and yield a processor to a rank that has
/// work. Messages go through shared memory.
const OPEN_MPI: [(&str, &str); 4] = [
    ("PMIX_MCA_gds", "hash"),
    ("OMPI_MCA_pml", "ob1"),
    ("OMPI_MCA_osc", "^ucx"),
    ("OMPI_MCA_mpi_yield_when_idle", "1"),
];

/// Shell command that silences the other ranks, whose output would be mixed with the first rank's.
const SILENT: &str = "exec \"$0\" \"$@\" >/dev/null";

/// The executor of an order: one process, or the ranks of a job.
pub struct Team<'a>(&'a SimpleCommunicator);

impl Team<'_> {
    /// Returns whether this process communicates with the grader.
    pub fn is_first(&self) -> bool {
        self.0.rank() == 0
    }

    /// Returns the order that the first rank received, on all ranks.
    pub fn share(&self, line: String) -> String {
        let (root, mut bytes) = (self.0.process_at_rank(0), line.into_bytes());
        let mut length = bytes.len() as u64;
        root.broadcast_into(&mut length);
        bytes.resize(length as usize, 0);
        root.broadcast_into(&mut bytes[..]);
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

/// Assembles the team and makes it do its work.
///
/// # Panics
/// If `mpiexec` is not installed.
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
