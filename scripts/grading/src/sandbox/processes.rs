//! The machine's processes, as Linux shows them in `/proc`. Elsewhere there are none.

use std::collections::BTreeMap;
use std::fs;

/// The ticks of a second, as Linux counts time for programs.
const TICKS: f64 = 100.0;

/// Bytes that a socket keeps of what is sent, unless it asks for more: Linux's `net.core.wmem_default`.
const SOCKET: u64 = 212_992;

/// A process.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Process {
    pub(crate) parent: u32,
    /// Bytes of memory.
    pub(crate) resident: u64,
    /// Seconds of processors, with those of the children that it has seen end.
    pub(crate) seconds: f64,
}

/// All of them, by number.
pub(crate) fn all() -> BTreeMap<u32, Process> {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let numbers = entries.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    numbers.filter_map(|number| Some((number, process(number)?))).collect()
}

/// A process and all that descend from it.
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

/// Bytes that may be in the buffers of a process's sockets, which are nobody's resident memory.
pub(super) fn in_sockets(number: u32) -> u64 {
    let files = fs::read_dir(format!("/proc/{number}/fd")).into_iter().flatten().flatten();
    let sockets = files.filter(|file| {
        fs::read_link(file.path()).is_ok_and(|to| to.to_string_lossy().starts_with("socket:"))
    });
    sockets.count() as u64 * SOCKET
}

fn process(number: u32) -> Option<Process> {
    let text = fs::read_to_string(format!("/proc/{number}/stat")).ok()?;
    // The name, in parentheses, may hold anything.
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let field = |at: usize| fields.get(at)?.parse::<u64>().ok();
    let ticks = (11..15).map(field).sum::<Option<u64>>()?;
    Some(Process {
        parent: field(1)? as u32,
        resident: field(21)? * rustix::param::page_size() as u64,
        seconds: (ticks as f64 / TICKS).max(precise(number)),
    })
}

/// Seconds of processors of a process's living threads, to the nanosecond; 0 where the system does not say.
fn precise(number: u32) -> f64 {
    let threads = fs::read_dir(format!("/proc/{number}/task")).into_iter().flatten().flatten();
    let seconds = threads.filter_map(|thread| {
        let text = fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse::<f64>().ok()
    });
    seconds.sum::<f64>() * 1e-9
}
