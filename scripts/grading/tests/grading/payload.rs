//! Attacks that a submission runs instead of answering. The file is part of a submission, not of
//! the tests.

use std::fs;
use std::io::Write;
use std::iter::from_fn;
use std::net::{TcpListener, TcpStream, ToSocketAddrs, UdpSocket};
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Once;

/// Tries every attack once.
pub(crate) fn all() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        homes();
        writes();
        sockets();
        parents();
        disks();
        processors();
        kernels();
        uncounted();
        memories();
        answers();
        others();
        overwrites_itself();
    });
}

fn succeeded(what: &str) -> ! {
    panic!("the attack succeeded: {what}");
}

fn must_fail<T, E>(what: &str, attack: Result<T, E>) {
    if attack.is_ok() {
        succeeded(what);
    }
}

/// Runs a program, which must not succeed.
fn must_not_run(program: &str, arguments: &[&str]) {
    let output = Command::new(program).args(arguments).output();
    if output.is_ok_and(|output| output.status.success()) {
        succeeded(program);
    }
}

fn homes() {
    for home in ["/root", "/home", "/work", "/mnt", "/srv", "/var"] {
        must_fail(home, fs::read_dir(home));
    }
    for file in ["/etc/passwd", "/etc/shadow", "/etc/hostname", "/kit/Cargo.toml"] {
        must_fail(file, fs::read(file));
    }
}

fn writes() {
    for folder in ["/", "/kit/", "/usr/", "/etc/", "/dev/", "/tmp/../kit/", "/lib/", "/proc/"] {
        must_fail(folder, fs::write(format!("{folder}escaped.rs"), "x"));
    }
}

fn sockets() {
    must_fail("a connection", TcpStream::connect("1.1.1.1:53"));
    must_fail("a connection to this machine", TcpStream::connect("127.0.0.1:22"));
    must_fail("a name server", "example.org:80".to_socket_addrs());
    let sent = UdpSocket::bind("0.0.0.0:0").and_then(|socket| socket.send_to(b"x", "1.1.1.1:53"));
    must_fail("a datagram", sent);
    // Unread data in a connection to itself would be memory that no limit counts.
    must_fail("a connection to itself", TcpListener::bind("127.0.0.1:0"));
}

/// Checks that neither the processes of the grader's user nor their data are visible.
fn parents() {
    let processes = fs::read_dir("/proc").into_iter().flatten().flatten();
    for process in processes {
        let Ok(number) = process.file_name().to_string_lossy().parse::<u32>() else { continue };
        for part in ["environ", "cmdline", "mem", "root/etc/passwd", "cwd/Cargo.toml"] {
            let Ok(bytes) = fs::read(process.path().join(part)) else { continue };
            let text = String::from_utf8_lossy(&bytes);
            if text.contains("CUTOFF_TEST_SECRET") || text.contains("\0grade\0") {
                succeeded(&format!("/proc/{number}/{part}"));
            }
        }
    }
    if std::env::var("CUTOFF_TEST_SECRET").is_ok() {
        succeeded("the environment");
    }
    // The program must not be root of anything.
    must_not_run("mount", &["-t", "tmpfs", "none", "/tmp"]);
}

/// Checks that the disk is not visible, and that files in memory have little space.
fn disks() {
    let block = vec![1; 8 << 20];
    for folder in ["/tmp", "/dev/shm"] {
        let mut files = 0;
        while fs::write(format!("{folder}/{files}"), &block).is_ok() {
            files += 1;
            if files > 32 {
                succeeded(&format!("{files} files in {folder}"));
            }
        }
        (0..=files).for_each(|file| drop(fs::remove_file(format!("{folder}/{file}"))));
    }
}

/// Checks that the program stays on the processors that it was given.
fn processors() {
    let own = std::process::id().to_string();
    must_not_run("taskset", &["-a", "-p", "-c", "0-63", &own]);
}

/// Checks that the kernel gives the program no keys, no uncounted memory, and no rights of root.
///
/// Without the filter, the program could read the keys of the grader, and become root in a new
/// namespace.
fn kernels() {
    must_not_run("keyctl", &["show"]);
    must_not_run("unshare", &["--user", "true"]);
    must_not_run("unshare", &["--user", "--map-root-user", "true"]);
    let keys = fs::read_to_string("/proc/keys").unwrap_or_default();
    if keys.contains("CUTOFF") {
        succeeded("a key of the grader's");
    }
}

/// Checks that the program cannot allocate memory outside its processes.
fn uncounted() {
    for code in [
        "import mmap; mmap.mmap(-1, 1 << 20)",
        "import mmap; mmap.mmap(open('/dev/zero', 'r+b').fileno(), 1 << 20)",
        "import os; os.memfd_create('m')",
        "from socket import *; socket().setsockopt(SOL_SOCKET, SO_SNDBUF, 1 << 22)",
    ] {
        must_not_run("python3", &["-c", code]);
    }
    for kind in [&["-M", "4096"][..], &["-S", "1"], &["-Q"]] {
        must_not_run("ipcmk", kind);
    }
    let page = [0; 4096];
    let mut ends = Vec::new();
    let mut held = 0;
    while let Ok((near, far)) = UnixStream::pair() {
        near.set_nonblocking(true).expect("it is ours");
        held += from_fn(|| (&near).write(&page).ok()).sum::<usize>();
        ends.push((near, far));
    }
    if held > 256 * 212_992 {
        succeeded(&format!("{held} bytes in the buffers of sockets"));
    }
}

/// Checks that a program can change no running program, not even itself.
fn memories() {
    let memory = fs::OpenOptions::new().write(true).open("/proc/self/mem");
    must_fail("its own memory as a file", memory);
    for call in [
        "ptrace(0, 0, 0, 0)",
        "process_vm_readv(1, None, 0, None, 0, 0)",
        "process_vm_writev(1, None, 0, None, 0, 0)",
        // 425 is io_uring_setup. 434 makes a descriptor of the first process, and 438 is
        // pidfd_getfd on it.
        "syscall(425, 1, ctypes.create_string_buffer(120))",
        "syscall(438, libc.syscall(434, 1, 0), 0, 0)",
        // 323 is userfaultfd, 298 perf_event_open, 321 bpf, 312 kcmp.
        "syscall(323, 1)",
        "syscall(298, ctypes.create_string_buffer(120), 0, -1, -1, 0)",
        "syscall(321, 0, ctypes.create_string_buffer(120), 120)",
        "syscall(312, 1, 1, 1, 0, 0)",
    ] {
        let code = format!("import ctypes; libc = ctypes.CDLL(None); exit(libc.{call} < 0)");
        must_not_run("python3", &["-c", &code]);
    }
}

/// Checks that the judging program is not visible, and that this program contains no right answer.
fn answers() {
    must_fail("the program that judges", fs::read("/kit/judge"));
    let own = fs::read("/proc/self/exe").unwrap_or_default();
    // These are parts of symbols, and texts that only a verdict contains. A dash is added to each,
    // so that this program does not contain the texts itself.
    for word in ["6oracle-5model", "6oracle-5right", "which does not point- straight away"] {
        let word = word.replace('-', "");
        if own.windows(word.len()).any(|window| window == word.as_bytes()) {
            succeeded(&word);
        }
    }
    // The answers go through a socket, which only its owner can write to.
    for process in ["self", "1", "2"] {
        for (path, target) in descriptors(process) {
            if target.starts_with("socket:") {
                must_fail("the grader's socket", fs::OpenOptions::new().write(true).open(path));
            }
        }
    }
}

/// Returns the path of each descriptor of a process, and what the descriptor refers to.
fn descriptors(process: &str) -> impl Iterator<Item = (PathBuf, String)> {
    let entries = fs::read_dir(format!("/proc/{process}/fd")).into_iter().flatten().flatten();
    entries.map(|entry| {
        let target = fs::read_link(entry.path()).unwrap_or_default();
        (entry.path(), target.to_string_lossy().into_owned())
    })
}

/// Checks that the memory, the descriptors and the open files of other processes are not
/// accessible.
fn others() {
    let own = std::process::id();
    for number in 1..100 {
        if number == own {
            continue;
        }
        let process = format!("/proc/{number}");
        let written = fs::OpenOptions::new().write(true).open(format!("{process}/mem"));
        must_fail("another's memory to write", written);
        for (_, target) in descriptors(&number.to_string()) {
            if target.starts_with("/kit") || target.contains("grade") {
                succeeded(&format!("a descriptor of process {number}: {target}"));
            }
        }
    }
    must_fail("the setting of a process", fs::write("/proc/self/oom_score_adj", "-1000"));
    must_fail("the setting of a process", fs::write("/proc/1/comm", "x"));
}

fn overwrites_itself() {
    let own = std::env::current_exe().unwrap_or_else(|_| "/kit/answer".into());
    must_fail("another program instead of this one", fs::write(&own, "x"));
    must_fail("no program instead of this one", fs::remove_file(&own));
}
