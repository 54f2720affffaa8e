//! A rank that is killed in the middle of a job.

use std::fs;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

use super::Job;

/// Time limit for the end of a job. A launcher may need seconds to notice that a rank is gone, and
/// more seconds to end the others.
const SOON: Duration = Duration::from_secs(15);

/// Time limit for the start of ranks.
const TO_START: Duration = Duration::from_secs(10);

/// Checks that the whole job ends when a rank is killed in the middle of the job.
///
/// The `job` is a run that would continue for hours and write to `out`. It must end soon, with a
/// message of the launcher, and without an output file that looks complete. In a first run the
/// root, which writes the file, is killed. In a second run the last rank is killed. Messages begin
/// with `name`.
///
/// # Panics
/// If the job does not end in this way.
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
        // The ranks have started; this wait brings them to the middle of the run.
        thread::sleep(Duration::from_millis(300));
        killed = Instant::now();
        kill_process(ids[victim], Signal::KILL).expect("a process of ours can be killed");
    });
    let took = killed.elapsed();
    assert!(!ended.status.success(), "{name}: the job succeeded, although a rank was killed");
    assert!(took < SOON, "{name}: the job continued for {took:?} after a rank was killed");
    let complaint = ended.stderr.to_lowercase() + &ended.stdout.to_lowercase();
    assert!(
        complaint.contains("kill"),
        "{name}: the job printed no message that a rank was killed"
    );
    assert!(!out.exists(), "{name}: the output file exists, although the run was not completed");
}

/// Waits for the process id in a file. `None` if it does not appear in time.
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
