//! Limits the processors of a program, and measures its processor time and its memory.

use std::io;

use crate::sandbox::processes::{all, bytes, family};

/// Starts a command that may use only `count` processors.
#[cfg(target_os = "linux")]
pub(crate) fn confined<T>(count: usize, start: impl FnOnce() -> io::Result<T>) -> io::Result<T> {
    use rustix::thread::{CpuSet, sched_getaffinity, sched_setaffinity};
    // A new child process inherits the processors of its parent.
    let all = sched_getaffinity(None)?;
    let mut few = CpuSet::new();
    (0..CpuSet::MAX_CPU).filter(|cpu| all.is_set(*cpu)).take(count).for_each(|cpu| few.set(cpu));
    sched_setaffinity(None, &few)?;
    let started = start();
    sched_setaffinity(None, &all)?;
    started
}

/// Starts a command. Processors can be limited on Linux only.
#[cfg(not(target_os = "linux"))]
pub(crate) fn confined<T>(_count: usize, start: impl FnOnce() -> io::Result<T>) -> io::Result<T> {
    start()
}

/// Returns the processor time of a process and its descendants, in seconds; `None` if unknown.
pub(crate) fn seconds(root: u32) -> Option<f64> {
    let all = all();
    (!all.is_empty()).then(|| family(&all, root).map(|(_, process)| process.seconds).sum())
}

/// Returns the largest memory that a process and each of its descendants have had, added up, in
/// bytes; `None` if unknown.
pub(crate) fn peak(root: u32) -> Option<u64> {
    let all = all();
    let peaks = family(&all, root)
        .filter_map(|(number, _)| bytes(&format!("/proc/{number}/status"), "VmHWM:"));
    (!all.is_empty()).then(|| peaks.sum())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::{Command, Stdio};

    use super::{confined, seconds};

    #[test]
    fn a_confined_program_sees_fewer_processors() {
        let mut command = Command::new("nproc");
        // This test is not about OpenMP's own setting.
        command.env_remove("OMP_NUM_THREADS");
        let output = confined(1, || command.output()).unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "1");
        let again = command.output().unwrap();
        let all = std::thread::available_parallelism().unwrap().get();
        assert_eq!(String::from_utf8_lossy(&again.stdout).trim(), all.to_string());
    }

    #[test]
    fn work_of_children_counts() {
        let mut busy = Command::new("sh");
        busy.args(["-c", "(i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done); echo; read x"]);
        let mut child = busy.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let mut out = child.stdout.take().unwrap();
        std::io::Read::read_exact(&mut out, &mut [0]).unwrap();
        let spent = seconds(child.id()).unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(spent > 0.0, "{spent}");
    }
}
