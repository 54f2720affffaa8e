//! A watch that reports where each rank is if a job hangs.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use std::{env, thread};

use crate::{calls, record};

/// Variable that makes ranks compare their calls. Its value is the number of seconds after which each
/// rank reports where it is.
const WATCH: &str = "CUTOFF_WATCH";

static ON: AtomicBool = AtomicBool::new(false);
static LOCATION: Mutex<String> = Mutex::new(String::new());

/// Makes `call`, which other ranks must make too, and records that this rank is in the call.
///
/// The variable `CUTOFF_WATCH` starts a watch: after that number of seconds, each rank that still runs
/// prints where it is. The watch also compares the calls that ranks make together, and ends the job if
/// they differ.
pub fn together<R>(what: &str, call: impl FnOnce() -> R) -> R {
    here(|| format!("in {what}"));
    calls::begin();
    let result = call();
    here(|| format!("past {what}"));
    result
}

/// Records where this rank is. Without a watch it does nothing.
pub(crate) fn here(location: impl FnOnce() -> String) {
    if ON.load(Ordering::Relaxed) {
        *LOCATION.lock().unwrap_or_else(PoisonError::into_inner) = location();
    }
}

/// Starts the watch, and a record of calls, if the environment asks for them.
pub(crate) fn start(rank: i32) {
    let seconds = env::var(WATCH).ok().and_then(|seconds| seconds.parse().ok());
    if !record::begin(rank) && seconds.is_none() {
        return;
    }
    ON.store(true, Ordering::Relaxed);
    mpi::ffi::watch(calls::hear);
    here(|| "before the first step".into());
    let Some(seconds) = seconds else { return };
    thread::spawn(move || {
        thread::sleep(Duration::from_secs(seconds));
        let location = LOCATION.lock().unwrap_or_else(PoisonError::into_inner);
        let call = calls::location().map_or_else(String::new, |call| format!(", {call}"));
        // One call prints the whole line, because all ranks print at the same time.
        let line = format!("after {seconds} s rank {rank} is {location}{call}\n");
        eprint!("{line}");
    });
}
