//! Runs processes with a time limit, and leaves none of them running.

use std::collections::BTreeSet;
use std::io::{self, Read};
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Mutex, Once};
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process_group};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::iterator::Signals;

/// Bytes that are kept of each stream: half from its beginning, half from its end.
const KEPT: usize = 1 << 20;

/// Time between asking a process to end and killing it.
const GRACE: Duration = Duration::from_secs(2);

/// Process groups that are running. The interrupt handler kills them.
static RUNNING: Mutex<BTreeSet<i32>> = Mutex::new(BTreeSet::new());

/// Result of a process.
#[derive(Debug)]
pub struct Finished {
    /// Exit status; `None` if the process exceeded its time limit.
    pub status: Option<ExitStatus>,
    /// Standard output. Of a long output, only the beginning and the end are kept.
    pub stdout: String,
    /// Standard error. Of a long output, only the beginning and the end are kept.
    pub stderr: String,
}

/// A process in its own process group. The group is killed when this value is dropped.
pub struct Started {
    /// The process itself.
    pub child: Child,
    group: i32,
}

/// Starts a command in its own process group.
pub fn start(command: &mut Command) -> io::Result<Started> {
    let child = command.process_group(0).spawn()?;
    let group = i32::try_from(child.id()).unwrap_or(i32::MAX);
    running(|groups| groups.insert(group));
    Ok(Started { child, group })
}

impl Drop for Started {
    fn drop(&mut self) {
        kill(self.group, Signal::KILL);
        let _ = self.child.wait();
        running(|groups| groups.remove(&self.group));
    }
}

/// Runs a command with an empty standard input, in its own process group. All processes of the
/// group are killed when the command ends or exceeds its time limit.
pub fn run(command: &mut Command, limit: Duration) -> io::Result<Finished> {
    run_with(command, Stdio::null(), limit)
}

/// Runs a command like [`run`], with this standard input.
pub fn run_with(command: &mut Command, stdin: Stdio, limit: Duration) -> io::Result<Finished> {
    command.stdin(stdin).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut started = start(command)?;
    let child = &mut started.child;
    let stdout = ends(child.stdout.take());
    let stderr = ends(child.stderr.take());
    let status = wait(child, Instant::now() + limit);
    if matches!(status, Ok(None)) {
        // A launcher of parallel programs ends these programs when it receives SIGTERM.
        kill(started.group, Signal::TERM);
        let _ = wait(&mut started.child, Instant::now() + GRACE);
    }
    drop(started);
    // A process that left the group may still hold the pipe, so the wait has a limit.
    let stdout = stdout.recv_timeout(GRACE).unwrap_or_default();
    let stderr = stderr.recv_timeout(GRACE).unwrap_or_default();
    Ok(Finished { status: status?, stdout, stderr })
}

/// Returns the message of the first panic in a process's stderr.
pub fn panic_in(stderr: &str) -> Option<&str> {
    let lines = stderr.lines().filter(|line| !line.trim().is_empty());
    lines.skip_while(|line| !line.contains(" panicked at ")).nth(1)
}

/// Makes Ctrl-C also kill the processes that [`run`] has started.
pub fn kill_all_on_interrupt() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // These signals exist on every system.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM, SIGHUP]) else { return };
        thread::spawn(move || {
            signals.forever().next();
            running(|groups| groups.iter().for_each(|group| kill(*group, Signal::KILL)));
            std::process::exit(130);
        });
    });
}

fn running<T>(change: impl FnOnce(&mut BTreeSet<i32>) -> T) -> T {
    change(&mut RUNNING.lock().unwrap_or_else(|poisoned| poisoned.into_inner()))
}

fn kill(group: i32, signal: Signal) {
    if let Some(group) = Pid::from_raw(group) {
        // The group may have ended already, which does no harm.
        let _ = kill_process_group(group, signal);
    }
}

fn wait(child: &mut Child, until: Instant) -> io::Result<Option<ExitStatus>> {
    let mut pause = Duration::from_millis(1);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() >= until {
            return Ok(None);
        }
        thread::sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(20));
    }
}

/// Reads a stream to its end in a new thread, and keeps its beginning and its end.
pub fn ends(stream: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (send, receive) = channel();
    thread::spawn(move || {
        let mut first = Vec::new();
        let mut last = Vec::new();
        if let Some(mut stream) = stream {
            // After an error, the rest of the stream counts as empty.
            let _ = stream.by_ref().take(KEPT as u64 / 2).read_to_end(&mut first);
            while let Ok(1..) = stream.by_ref().take(KEPT as u64 / 2).read_to_end(&mut last) {
                last.drain(..last.len().saturating_sub(KEPT / 2));
            }
        }
        first.extend(last);
        let _ = send.send(String::from_utf8_lossy(&first).into_owned());
    });
    receive
}

#[cfg(test)]
mod tests {
    use std::process::Command;
    use std::time::{Duration, Instant};

    use super::run;

    fn shell(script: &str) -> Command {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        command
    }

    /// Whether a process is running. A process that ended has disappeared, or is a zombie until its
    /// new parent notices.
    fn is_alive(process: &str) -> bool {
        let state = std::fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
        !state.is_empty() && !state.contains(") Z ")
    }

    #[test]
    fn output_and_status_come_back() {
        let done =
            run(&mut shell("echo out; echo err >&2; exit 3"), Duration::from_secs(60)).unwrap();
        assert_eq!((&*done.stdout, &*done.stderr), ("out\n", "err\n"));
        assert_eq!(done.status.and_then(|status| status.code()), Some(3));
    }

    #[test]
    fn a_hanging_process_is_ended_with_its_children() {
        let start = Instant::now();
        let done = run(
            &mut shell("trap '' TERM; sleep 600 & echo $!; wait; sleep 600"),
            Duration::from_millis(200),
        )
        .unwrap();
        assert!(done.status.is_none());
        assert!(start.elapsed() < Duration::from_secs(60));
        let child = done.stdout.trim();
        assert!(!child.is_empty());
        // The system may take a moment to end the process.
        while is_alive(child) {
            assert!(start.elapsed() < Duration::from_secs(60), "process {child} is still there");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    #[test]
    fn of_much_output_the_end_is_kept_too() {
        let done = run(&mut shell("echo first; seq 1000000; echo last"), Duration::from_secs(60));
        let stdout = done.unwrap().stdout;
        assert!(stdout.starts_with("first\n1\n") && stdout.ends_with("\n1000000\nlast\n"));
        assert!(stdout.len() <= 1 << 20);
    }

    #[test]
    fn endless_output_does_not_fill_the_memory() {
        let done = run(&mut shell("yes"), Duration::from_millis(300)).unwrap();
        assert!(done.stdout.len() <= 1 << 20);
    }
}
