//! Where a rank is, said when its job stands still.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use std::{env, thread};

use crate::{calls, record};

/// Asks ranks to compare their calls, and each to say where it is after some seconds.
const WATCH: &str = "CUTOFF_WATCH";

static ON: AtomicBool = AtomicBool::new(false);
static LOCATION: Mutex<String> = Mutex::new(String::new());

/// Makes `call`, which other ranks must make too, and notes that this rank is in it, for the watch that the
/// environment variable `CUTOFF_WATCH` starts: after that number of seconds each rank that still runs prints where it is.
/// What ranks call together is compared, and ends the job at once where they differ.
pub fn together<R>(what: &str, call: impl FnOnce() -> R) -> R {
    here(|| format!("in {what}"));
    calls::begin();
    let result = call();
    here(|| format!("past {what}"));
    result
}

/// Notes where this rank is; nothing without a watch.
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
        // In one piece, since all ranks print at once.
        let line = format!("after {seconds} s rank {rank} is {location}{call}\n");
        eprint!("{line}");
    });
}
