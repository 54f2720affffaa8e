//! The machine's processes, as Linux lists them in `/proc`. On other systems the list is empty.

use std::collections::BTreeMap;
use std::fs;

/// Clock ticks per second in the times that the files of `/proc` contain.
const TICKS: f64 = 100.0;

/// Bytes that a socket buffers by default: Linux's `net.core.wmem_default`.
const SOCKET: u64 = 212_992;

/// A process.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Process {
    pub(crate) parent: u32,
    /// Resident memory in bytes.
    pub(crate) resident: u64,
    /// Processor time in seconds, including the time of children that have ended.
    pub(crate) seconds: f64,
}

/// Returns all processes by number.
pub(crate) fn all() -> BTreeMap<u32, Process> {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let numbers = entries.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    numbers.filter_map(|number| Some((number, process(number)?))).collect()
}

/// Returns a process and all its descendants.
pub(crate) fn family(
    all: &BTreeMap<u32, Process>,
    root: u32,
) -> impl Iterator<Item = (u32, &Process)> {
    let mut family = vec![root];
    let mut seen = 0;
    while let Some(&parent) = family.get(seen) {
        seen += 1;
        let children = all.iter().filter(|(_, process)| process.parent == parent);
        family.extend(children.map(|(child, _)| *child));
    }
    family.into_iter().filter_map(|number| Some((number, all.get(&number)?)))
}

/// Returns the bytes that the buffers of a process's sockets may hold. They are not part of the
/// resident memory.
pub(super) fn in_sockets(number: u32) -> u64 {
    let files = fs::read_dir(format!("/proc/{number}/fd")).into_iter().flatten().flatten();
    let sockets = files.filter(|file| {
        fs::read_link(file.path()).is_ok_and(|to| to.to_string_lossy().starts_with("socket:"))
    });
    sockets.count() as u64 * SOCKET
}

/// Returns the bytes that a line of a file of `/proc` contains, such as `MemTotal:` of `/proc/meminfo`.
pub(crate) fn bytes(file: &str, name: &str) -> Option<u64> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()? << 10)
}

fn process(number: u32) -> Option<Process> {
    let text = fs::read_to_string(format!("/proc/{number}/stat")).ok()?;
    // The name, in parentheses, may contain any character.
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let field = |at: usize| fields.get(at)?.parse::<u64>().ok();
    let ticks = (11..15).map(field).sum::<Option<u64>>()?;
    Some(Process {
        parent: field(1)? as u32,
        resident: field(21)? * rustix::param::page_size() as u64,
        seconds: (ticks as f64 / TICKS).max(precise(number)),
    })
}

/// Returns the processor time of a process's living threads, in seconds.
///
/// The precision is a nanosecond. The result is 0 if the system does not report the time.
fn precise(number: u32) -> f64 {
    let threads = fs::read_dir(format!("/proc/{number}/task")).into_iter().flatten().flatten();
    let seconds = threads.filter_map(|thread| {
        let text = fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse::<f64>().ok()
    });
    seconds.sum::<f64>() * 1e-9
}
