//! A file with the calls of a rank, from which `cargo lab run --watch` makes a table of all ranks.

use std::env;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use mpi::ffi::Call;

/// Variable with the folder of the files, one for each rank.
const FOLDER: &str = "CUTOFF_CALLS";

/// Greatest number of calls in a table.
const MOST: usize = 2000;

static RECORD: Mutex<Option<Record>> = Mutex::new(None);

struct Record {
    file: File,
    calls: usize,
}

/// Begins a record if the environment asks for one. Returns whether it does.
pub(crate) fn begin(rank: i32) -> bool {
    let Some(folder) = env::var_os(FOLDER) else { return false };
    let file = File::create(Path::new(&folder).join(format!("{rank}.txt")));
    let record = file.map(|file| Record { file, calls: 0 });
    *RECORD.lock().unwrap_or_else(PoisonError::into_inner) = record.ok();
    true
}

/// Writes a line about a call before it is made: its number on all ranks, or 0; its name; the other
/// rank, or -1; the tag; its location. `location` is called only if there is a record.
pub(crate) fn note(number: u64, call: &Call, location: impl FnOnce() -> Option<String>) {
    let mut record = RECORD.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(Record { file, calls }) = record.as_mut().filter(|record| record.calls < MOST) else {
        return;
    };
    // A table shows calls in a lab's own files only.
    let Some(location) = location() else { return };
    *calls += 1;
    let number = if call.is_collective { number } else { 0 };
    let other = call.other.unwrap_or([-1, -1]);
    // There is no buffer, so that the file of a job that hangs is complete.
    let _ = writeln!(file, "{number}\t{}\t{}\t{}\t{location}", call.name, other[0], other[1]);
}
