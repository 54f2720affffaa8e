//! A rank that is killed in the middle of a job.

use std::fs;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

use super::Job;

/// A launcher may take a second or two to see that a rank is gone, and some to end the other ranks.
const SOON: Duration = Duration::from_secs(15);

/// What ranks get to start.
const TO_START: Duration = Duration::from_secs(10);

/// A rank that is killed in the middle of the `job`, a run that would go on for hours and write to `out`,
/// ends the whole job: soon, with a word of the launcher's, and without an output file that looks as if the
/// run had ended. So does the last rank, and so does the root, which writes the file. `name` begins the
/// messages.
///
/// # Panics
/// It does not.
pub fn ends_when_a_rank_is_killed(name: &str, job: &Job, out: &Path) {
    for victim in [0, job.ranks() - 1] {
        ends_when_killed(&format!("{name}, rank {victim} killed"), job, out, victim);
    }
}

fn ends_when_killed(name: &str, job: &Job, out: &Path, victim: usize) {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let mut killed = Instant::now();
    let ended = job.clone().ids_into(folder.path()).run_beside(|| {
        let ids: Vec<Pid> = (0..job.ranks())
            .map(|rank| wait_for_id(&folder.path().join(rank.to_string())))
            .collect::<Option<_>>()
            .unwrap_or_else(|| panic!("{name}: the ranks did not start within {TO_START:?}"));
        // They have started; now they shall be in the middle of it.
        thread::sleep(Duration::from_millis(300));
        killed = Instant::now();
        kill_process(ids[victim], Signal::KILL).expect("a process of ours can be killed");
    });
    let took = killed.elapsed();
    assert!(!ended.status.success(), "{name}: a rank was killed and the job succeeded");
    assert!(took < SOON, "{name}: a rank was killed and the job went on for {took:?}");
    let complaint = ended.stderr.to_lowercase() + &ended.stdout.to_lowercase();
    assert!(complaint.contains("kill"), "{name}: no message says that a rank was killed");
    assert!(!out.exists(), "{name}: the output of a run that never ended is there");
}

/// The process id in a file, as soon as it is there.
fn wait_for_id(path: &Path) -> Option<Pid> {
    let start = Instant::now();
    while start.elapsed() < TO_START {
        let id =
            fs::read_to_string(path).ok().and_then(|id| Pid::from_raw(id.trim().parse().ok()?));
        if id.is_some() {
            return id;
        }
        thread::sleep(Duration::from_millis(20));
    }
    None
}
