//! The ranks of a submission's program: it starts itself again under `mpiexec`.
//!
//! In a sandbox there is neither a home folder nor room for shared files, so Open MPI is told to use
//! the loopback network for everything.

use std::env;
use std::fs::{self, File};
use std::path::PathBuf;
use std::process::Command;

use lab_machine::Mpiexec;

/// Tells a program that it is a rank of a job.
const RANK_OF: &str = "CUTOFF_RANK_OF";

/// Where the launchers of Open MPI and MPICH tell a rank its number.
const RANK: [&str; 3] = ["OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"];

/// What Open MPI needs to run without shared files and without spinning, and to end a job that hangs; and a watch,
/// which does not let a rank leave out a collective operation because it has nothing to send. Limits are in seconds.
const ENVIRONMENT: [(&str, &str); 8] = [
    ("MPIEXEC_TIMEOUT", "20"),
    ("PMIX_MCA_gds", "hash"),
    ("OMPI_MCA_pml", "ob1"),
    ("OMPI_MCA_btl", "self,tcp"),
    ("OMPI_MCA_btl_tcp_if_include", "lo"),
    ("OMPI_MCA_mpi_yield_when_idle", "1"),
    ("OMPI_MCA_osc", "^ucx"),
    ("CUTOFF_WATCH", "18"),
];

/// An empty file for the answers of this rank; `None` if this process is no rank.
pub(super) fn file_of_this_rank() -> Option<File> {
    env::var_os(RANK_OF)?;
    let rank = RANK.iter().find_map(|name| env::var(name).ok()?.parse().ok());
    let file = File::create(path(rank.expect("the launcher numbers its ranks")));
    Some(file.expect("a rank can write its answers"))
}

/// Runs this program on so many ranks. Returns the answers of all ranks, one behind another.
///
/// # Panics
/// The job failed.
pub(super) fn run(ranks: usize) -> Vec<u8> {
    let mut job = itself_on(ranks);
    job.env(RANK_OF, ranks.to_string()).envs(ENVIRONMENT);
    let ended = job.status().expect("mpiexec starts");
    assert!(ended.success(), "on {ranks} ranks the job failed, or gave no answer in time");
    let answers = (0..ranks).map(|rank| fs::read(path(rank)).expect("each rank wrote its answers"));
    answers.collect::<Vec<_>>().concat()
}

/// The command that starts this program, with its arguments, as the ranks of a job; in a sandbox too, which
/// has no environment.
///
/// # Panics
/// There is no MPI.
pub fn itself_on(ranks: usize) -> Command {
    let this = env::current_exe().expect("a program knows its own path");
    let launcher = Mpiexec::find().unwrap_or_else(|error| panic!("{error}"));
    let mut job = launcher.start(ranks, &this);
    for (name, value) in [("PATH", "/usr/local/bin:/usr/bin:/bin"), ("HOME", "/tmp")] {
        if env::var_os(name).is_none() {
            job.env(name, value);
        }
    }
    job.args(env::args_os().skip(1));
    job
}

fn path(rank: usize) -> PathBuf {
    env::temp_dir().join(format!("answers-of-rank-{rank}"))
}
