//! Memory that a sandbox uses outside its processes: files in memory, and unread data in
//! connections.

use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use rustix::fs::statvfs;

/// Folders of a sandbox whose files are in memory.
const FOLDERS: [&str; 2] = ["tmp", "dev/shm"];

/// Bytes of memory that an empty file takes: its name and the system's data about it.
const FILE: u64 = 1280;

/// Largest number of bytes of memory that one unread byte in a connection takes.
const SPREAD: u64 = 2;

/// Returns the bytes that a process's sandbox holds outside processes; 0 if there is no sandbox.
pub(super) fn held(number: u32) -> u64 {
    in_files(number) + in_connections(number)
}

fn in_files(number: u32) -> u64 {
    let root = Path::new("/proc").join(number.to_string()).join("root");
    let folders = FOLDERS.iter().map(|folder| (root.join(folder), Path::new("/").join(folder)));
    // While a sandbox is being made, it still has the machine's folders.
    let own = folders.filter(|(own, machine)| device(own) != device(machine));
    let disks = own.filter_map(|(own, _)| statvfs(own).ok());
    let bytes = disks.map(|disk| {
        let files = disk.f_files.saturating_sub(disk.f_ffree);
        files * FILE + disk.f_blocks.saturating_sub(disk.f_bfree) * disk.f_frsize
    });
    bytes.sum()
}

/// Returns the number of the disk that a folder is on.
fn device(folder: &Path) -> Option<u64> {
    fs::metadata(folder).map(|folder| folder.dev()).ok()
}

fn in_connections(number: u32) -> u64 {
    let process = number.to_string();
    if network(&process).is_none_or(|own| Some(own) == network("self")) {
        return 0;
    }
    let tables =
        ["tcp", "tcp6"].map(|kind| fs::read_to_string(format!("/proc/{process}/net/{kind}")));
    SPREAD * tables.into_iter().flatten().map(|table| waiting(&table)).sum::<u64>()
}

/// Returns the network namespace of a process.
fn network(process: &str) -> Option<PathBuf> {
    fs::read_link(format!("/proc/{process}/ns/net")).ok()
}

/// Sums the unread bytes, sent and received, in the fifth column of a connection table of the
/// system.
fn waiting(table: &str) -> u64 {
    let bytes = table.lines().skip(1).filter_map(|line| {
        let (sent, received) = line.split_whitespace().nth(4)?.split_once(':')?;
        Some(u64::from_str_radix(sent, 16).ok()? + u64::from_str_radix(received, 16).ok()?)
    });
    bytes.sum()
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::Stdio;
    use std::thread::sleep;
    use std::time::Duration;

    use super::{FILE, held, waiting};
    use crate::sandbox::processes::{all, family};
    use crate::sandbox::{Limits, Sandbox};
    use lab_kit::Kit;
    use lab_kit::process::start;

    #[test]
    fn what_waits_is_read() {
        let table = "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when\n\
                     0: 0100007F:1F90 00000000:0000 0A 00000000:00000010 00:00000000\n\
                     1: 0100007F:1F90 0100007F:8AE2 01 00000100:00000001 00:00000000\n";
        assert_eq!(waiting(table), 0x111);
        assert_eq!(held(std::process::id()), 0, "it is in no sandbox");
    }

    #[test]
    fn empty_files_in_memory_are_counted() {
        let limit = Duration::from_secs(60);
        let limits = Limits { run: limit, build: limit, loopback: false };
        let Ok(sandbox) = Sandbox::find(&Kit::find().unwrap(), false, limits) else {
            return eprintln!("skipped: there is no sandbox here");
        };
        let folder = sandbox.folder().unwrap();
        let mut command = sandbox.shell(folder.path());
        let script = "i=0; while [ $i -lt 5000 ]; do : > /dev/shm/$i; i=$((i + 1)); done; sleep 60";
        let started = start(command.args(["-c", script]).stdin(Stdio::null())).unwrap();
        // The program takes a moment to make the files.
        let mut bytes = 0;
        for _ in 0..600 {
            let all = all();
            bytes = family(&all, started.child.id()).last().map_or(0, |(number, _)| held(number));
            if bytes >= 5000 * FILE {
                return;
            }
            sleep(Duration::from_millis(50));
        }
        panic!("only {bytes} bytes are counted");
    }
}
