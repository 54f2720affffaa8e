//! The ranks of a submission's program, which starts itself again under `mpiexec`.
//!
//! A sandbox has neither a home folder nor space for shared files, so Open MPI must use the
//! loopback network for everything.

use std::env;
use std::fs::{self, File};
use std::path::PathBuf;
use std::process::Command;

use lab_machine::Mpiexec;

/// Variable that marks a program as a rank of a job.
const RANK_OF: &str = "CUTOFF_RANK_OF";

/// Variables in which the launchers of Open MPI and MPICH pass a rank its number.
const RANK: [&str; 3] = ["OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"];

/// Settings for Open MPI: no shared files, no spinning, and an end to jobs that hang. Limits are in
/// seconds.
///
/// The settings also enable the watch, which detects a rank that omits a collective operation
/// because the rank has nothing to send.
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

/// Returns an empty file for the answers of this rank. `None` if this process is not a rank.
pub(super) fn file_of_this_rank() -> Option<File> {
    env::var_os(RANK_OF)?;
    let rank = RANK.iter().find_map(|name| env::var(name).ok()?.parse().ok());
    let file = File::create(path(rank.expect("the launcher numbers its ranks")));
    Some(file.expect("a rank can write its answers"))
}

/// Runs this program on `ranks` ranks. Returns the concatenated answers of all ranks.
///
/// # Panics
/// If the job fails.
pub(super) fn run(ranks: usize) -> Vec<u8> {
    let mut job = itself_on(ranks);
    job.env(RANK_OF, ranks.to_string()).envs(ENVIRONMENT);
    let ended = job.status().expect("mpiexec starts");
    assert!(ended.success(), "the job on {ranks} ranks failed, or gave no answer in time");
    let answers = (0..ranks).map(|rank| fs::read(path(rank)).expect("each rank wrote its answers"));
    answers.collect::<Vec<_>>().concat()
}

/// Returns the command that starts this program, with its arguments, as the ranks of a job. The
/// command also works in a sandbox, which has no environment variables.
///
/// # Panics
/// If MPI is not installed.
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
