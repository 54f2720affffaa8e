//! Watches the memory of all processes that grading has started.
//!
//! The system's memory limits count each process separately, and a submission may have many. So the
//! grader watches each of its child processes together with all descendants, and kills the whole
//! group when it holds too much memory. Three kinds of memory count: resident memory, the buffers
//! of sockets, and memory of the sandbox outside processes ([`super::beside`]). Other memory is
//! small or cannot be allocated. The system limits the memory of pipes (64 MiB for a user, then one
//! or two pages for each pipe). [`super::filter`] refuses the calls that allocate other memory.
//!
//! A control group with `memory.max` would count all of this memory. It needs a group that was
//! delegated to the user who grades. Containers have no such group, and with systemd each program
//! would become a unit of the user's manager.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process_group};

use super::beside;
use super::processes::{Process, all, bytes, family, in_sockets};

/// Maximal memory of all processes of a submission together, in bytes, on any machine.
const MEMORY_IN_ALL: u64 = 8 << 30;

/// Interval between two checks.
const GLANCE: Duration = Duration::from_millis(200);

/// Guard that kills programs that hold too much memory, until the guard is dropped.
pub(crate) struct Guard {
    over: Arc<AtomicBool>,
    watcher: Option<JoinHandle<()>>,
}

impl Guard {
    /// Starts to watch `jobs` submissions that run at the same time. Together they get half the
    /// memory.
    pub(crate) fn set(jobs: usize) -> Self {
        let over = Arc::new(AtomicBool::new(false));
        let total = memory("MemTotal:");
        let limit = total.map(|total| (total / 2 / jobs as u64).min(MEMORY_IN_ALL));
        // If the system does not report its memory, only the limits for each process apply.
        let watcher = limit.map(|limit| {
            let over = Arc::clone(&over);
            thread::spawn(move || watch(&over, total, limit))
        });
        Self { over, watcher }
    }
}

/// Kills programs that hold more than `limit` bytes, until the watch is `over`.
fn watch(over: &AtomicBool, total: Option<u64>, limit: u64) {
    while !over.load(Ordering::Relaxed) {
        if may_be_held(total, memory("MemAvailable:"), limit) {
            end_the_greedy(&all(), std::process::id(), limit);
        }
        thread::sleep(GLANCE);
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
        if let Some(watcher) = self.watcher.take() {
            // If the watcher has panicked, nothing is lost here.
            let _ = watcher.join();
        }
    }
}

/// Whether some process might hold more than `limit` bytes, judging by the machine's memory in use.
///
/// Reading the memory of each process would take milliseconds of processor time, which would
/// disturb the timed programs.
fn may_be_held(all: Option<u64>, left: Option<u64>, limit: u64) -> bool {
    all.zip(left).is_none_or(|(all, left)| all.saturating_sub(left) > limit)
}

fn end_the_greedy(all: &BTreeMap<u32, Process>, own: u32, limit: u64) {
    for (&child, _) in all.iter().filter(|(_, process)| process.parent == own) {
        if held(all, child) > limit
            && let Some(group) = i32::try_from(child).ok().and_then(Pid::from_raw)
        {
            // The child is the leader of its group. If it has ended, its memory is free.
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
}

/// Returns the bytes that a process and its descendants hold. If there is a sandbox, the youngest
/// descendant is inside it.
fn held(all: &BTreeMap<u32, Process>, root: u32) -> u64 {
    let mut bytes = 0;
    let mut youngest = None;
    for (number, process) in family(all, root) {
        bytes += process.resident + in_sockets(number);
        youngest = Some(number);
    }
    bytes + youngest.map_or(0, beside::held)
}

/// Returns the machine's total (`MemTotal:`) or available (`MemAvailable:`) memory in bytes.
fn memory(which: &str) -> Option<u64> {
    bytes("/proc/meminfo", which)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::collections::BTreeMap;
    use std::os::unix::process::{CommandExt, ExitStatusExt};
    use std::process::{Command, Stdio};
    use std::thread;

    use super::{GLANCE, Process, all, end_the_greedy, may_be_held, memory};

    #[test]
    fn nobody_is_looked_at_while_memory_is_left() {
        assert!(!may_be_held(Some(24), Some(20), 8));
        assert!(may_be_held(Some(24), Some(15), 8));
        assert!(may_be_held(Some(24), None, 8), "it does not say");
        assert!(memory("MemAvailable:").unwrap() <= memory("MemTotal:").unwrap());
    }

    /// Returns a process and its own children, because the children of other tests must survive.
    fn with_children(number: u32) -> BTreeMap<u32, Process> {
        let mut all = all();
        all.retain(|it, process| *it == number || process.parent == number);
        all
    }

    #[test]
    fn who_holds_too_much_is_ended() {
        let mut command = Command::new("sh");
        command.args(["-c", "sleep 600 & wait"]).stdin(Stdio::null()).process_group(0);
        let mut child = command.spawn().unwrap();
        let own = std::process::id();
        let number = child.id();
        end_the_greedy(&with_children(number), own, u64::MAX);
        assert!(child.try_wait().unwrap().is_none(), "it holds little");
        // The system may not report any memory of a process that has just started, so several
        // checks are needed.
        for _ in 0..50 {
            end_the_greedy(&with_children(number), own, 0);
            thread::sleep(GLANCE / 10);
        }
        assert_eq!(child.wait().unwrap().signal(), Some(9));
    }
}
