//! A job: all ranks from their start to their end.

use std::backtrace::{Backtrace, BacktraceStatus};
use std::panic::{self, PanicHookInfo};
use std::process::ExitCode;
use std::{env, thread};

use common::{BuildError, Variant, hard, soft};
use mpi::Threading;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::{calls, watch};

/// The exit code of a job in which a rank panicked, which is also the code of other programs that
/// panic.
const PANICKED: i32 = 101;

/// Variables in which the launchers of Open MPI and MPICH pass the number of ranks.
const NUMBER_OF_RANKS: [&str; 2] = ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE"];

/// The longest message that is sent as one message: its length must be an `i32`.
const LONGEST: usize = 1 << 30;

/// Runs a soft-disc lab on all ranks, from its command line to its exit code.
pub fn drive(variants: &[Variant<dyn soft::Simulation>]) -> ExitCode {
    as_rank(|world| soft::drive_on_rank(variants, world.rank() == 0))
}

/// Runs a hard-disc lab on all ranks, from its command line to its exit code. The root reads the
/// input and shares it with all ranks.
pub fn drive_hard(variants: &[Variant<dyn hard::Simulation>]) -> ExitCode {
    as_rank(|world| hard::drive_on_rank(variants, world.rank() == 0, |input| share(world, input)))
}

/// Sends the root's bytes to all ranks, and returns them on every rank.
fn share(world: &SimpleCommunicator, bytes: Option<Vec<u8>>) -> Vec<u8> {
    let root = world.process_at_rank(0);
    let mut bytes = bytes.unwrap_or_default();
    let mut length = bytes.len() as u64;
    root.broadcast_into(&mut length);
    bytes.resize(length as usize, 0);
    bytes.chunks_mut(LONGEST).for_each(|chunk| root.broadcast_into(chunk));
    bytes
}

/// Starts MPI, runs `program` as one of the ranks of the job, and ends MPI.
///
/// If `program` panics or returns a failure on any rank, the whole job ends: other ranks may be
/// waiting in a call that this rank will never make. Only the thread that called `as_rank` may
/// communicate with other ranks.
pub fn as_rank(program: impl FnOnce(&SimpleCommunicator) -> ExitCode) -> ExitCode {
    let Some((universe, threads)) = mpi::initialize_with_threading(Threading::Funneled) else {
        eprintln!("error: MPI is already running in this program");
        return ExitCode::FAILURE;
    };
    let world = universe.world();
    if let Some(complaint) = misfit(&world, threads) {
        eprintln!("error: {complaint}");
        world.abort(1);
    }
    end_job_on_panic(&world);
    watch::start(world.rank());
    let code = program(&world);
    if code != ExitCode::SUCCESS {
        world.abort(1);
    }
    code
}

/// Returns the communicator of all ranks.
///
/// # Errors
/// If MPI is not running because the program did not start with [`as_rank`].
pub fn world() -> Result<SimpleCommunicator, BuildError> {
    if mpi::is_initialized() && !mpi::is_finalized() {
        Ok(SimpleCommunicator::world())
    } else {
        Err(BuildError("this variant runs on ranks: start its program with mpiexec".into()))
    }
}

/// Describes why the program does not fit its launcher. `None` if it fits.
///
/// If the launcher belongs to a different MPI library, it starts n jobs of one rank each, which would
/// all write the same file.
fn misfit(world: &SimpleCommunicator, threads: Threading) -> Option<String> {
    let started = NUMBER_OF_RANKS.iter().find_map(|name| env::var(name).ok()?.parse().ok());
    if let Some(started) = started.filter(|&started: &i32| started > world.size()) {
        return Some(format!(
            "mpiexec started {started} ranks, but each rank sees only {}: this program was built with a different MPI \
             library ({})",
            world.size(),
            library(),
        ));
    }
    (threads < Threading::Funneled).then(|| format!("{} was built without threads", library()))
}

fn library() -> String {
    let version = mpi::environment::library_version().unwrap_or_default();
    version.split([',', '\n']).next().unwrap_or_default().trim().to_owned()
}

/// Makes a panic print its usual message after the number of its rank, and then end the job.
fn end_job_on_panic(world: &SimpleCommunicator) {
    let rank = world.rank();
    let main = thread::current().id();
    panic::set_hook(Box::new(move |info| {
        let of_mpi = info.location().filter(|at| at.file().ends_with("collective.rs"));
        let words = of_mpi
            .and_then(|_| calls::wrong_side(rank, &info.to_string(), &Backtrace::force_capture()));
        // One call prints the whole message, because several ranks may panic at once.
        let words = words.unwrap_or_else(|| words_of_panic(rank, info)) + "\n";
        eprint!("{words}");
        if thread::current().id() == main {
            SimpleCommunicator::world().abort(PANICKED);
        }
        // A worker thread must not call MPI; the launcher ends the job when a rank dies.
        std::process::abort();
    }));
}

/// Returns the rank, and the message that a panic prints in a program without ranks.
fn words_of_panic(rank: i32, info: &PanicHookInfo<'_>) -> String {
    let thread = thread::current();
    let name = thread.name().unwrap_or("without a name");
    let at = calls::panicked_at(info);
    let payload = info.payload_as_str().unwrap_or("no reason is given");
    let trace = Backtrace::capture();
    let trace = match trace.status() {
        BacktraceStatus::Captured => format!("\nstack backtrace:\n{trace}"),
        _ => String::new(),
    };
    format!("rank {rank}:\nthread '{name}' panicked at {at}:\n{payload}{trace}")
}
