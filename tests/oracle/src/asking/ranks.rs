//! The ranks of a submission's program, which starts itself again under `mpiexec`.
//!
//! A sandbox has neither a home folder nor space for shared files, so Open MPI must use the
//! loopback network for everything.

use std::env;
use std::io::{self, Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::process::{Child, Command};
use std::thread::{self, sleep};
use std::time::Duration;

use lab_machine::Mpiexec;
use tempfile::TempDir;

/// Variable that marks a program as a rank of a job, and contains the path of the job's socket.
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

/// Returns this rank's connection to the program that started the job. `None` if this process is
/// not a rank.
///
/// The function waits until all ranks of the job are connected. So the submission's code starts only
/// after the socket has stopped accepting connections.
///
/// # Panics
/// If the program that started the job does not answer.
pub(super) fn connect() -> Option<UnixStream> {
    let socket = env::var_os(RANK_OF)?;
    let rank = RANK.iter().find_map(|name| env::var(name).ok()?.parse::<u8>().ok());
    let rank = rank.expect("the launcher numbers its ranks");
    let mut stream = UnixStream::connect(socket).expect("a rank can connect to its job's socket");
    stream.write_all(&[rank]).expect("a rank can send its number");
    stream.read_exact(&mut [0]).expect("all ranks connect");
    Some(stream)
}

/// Runs this program on `ranks` ranks. Returns the concatenated answers of all ranks.
///
/// # Panics
/// If the job fails.
pub(super) fn run(ranks: usize) -> Vec<u8> {
    let folder = TempDir::new().expect("a job needs a folder for its socket");
    let socket = folder.path().join("answers");
    let listener = UnixListener::bind(&socket).expect("a job needs a socket");
    let mut job = itself_on(ranks);
    let mut job = job.env(RANK_OF, &socket).envs(ENVIRONMENT).spawn().expect("mpiexec starts");
    let streams = accept(listener, ranks, &mut job).expect("the ranks connect");
    let (ended, answers) = thread::scope(|scope| {
        let readers: Vec<_> =
            streams.into_iter().map(|stream| scope.spawn(move || read(stream))).collect();
        let ended = job.wait().expect("mpiexec ends");
        let answers = readers.into_iter().flat_map(|it| it.join().expect("readers do not panic"));
        (ended, answers.collect())
    });
    assert!(ended.success(), "the job on {ranks} ranks failed, or gave no answer in time");
    answers
}

/// Accepts one connection from each rank and tells all ranks to start. Returns the connections in
/// the order of the ranks; they are fewer if the job ends early.
fn accept(listener: UnixListener, ranks: usize, job: &mut Child) -> io::Result<Vec<UnixStream>> {
    listener.set_nonblocking(true)?;
    let mut numbered = Vec::new();
    while numbered.len() < ranks && job.try_wait()?.is_none() {
        match listener.accept() {
            Ok((mut stream, _)) => {
                stream.set_nonblocking(false)?;
                let mut rank = [0];
                stream.read_exact(&mut rank)?;
                numbered.push((rank, stream));
            }
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {
                sleep(Duration::from_millis(1));
            }
            Err(error) => return Err(error),
        }
    }
    drop(listener);
    numbered.sort_by_key(|(rank, _)| *rank);
    let mut streams: Vec<_> = numbered.into_iter().map(|(_, stream)| stream).collect();
    for stream in &mut streams {
        stream.write_all(&[1])?;
    }
    Ok(streams)
}

/// Reads the answers of a rank. A rank that crashes leaves a part of them.
fn read(mut stream: UnixStream) -> Vec<u8> {
    let mut answers = Vec::new();
    let _ = stream.read_to_end(&mut answers);
    answers
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
