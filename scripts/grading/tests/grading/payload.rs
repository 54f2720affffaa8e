//! What a submission might try while its probe runs. Part of a submission, not of the tests.

use std::fs;
use std::net::{TcpStream, ToSocketAddrs, UdpSocket};
use std::process::Command;
use std::sync::Once;

/// Tries everything once.
pub(crate) fn all() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        homes();
        writes();
        sockets();
        parents();
        disks();
        processors();
        overwrites_itself();
    });
}

fn succeeded(what: &str) -> ! {
    panic!("the attack succeeded: {what}");
}

fn homes() {
    for home in ["/root", "/home", "/work", "/mnt", "/srv", "/var"] {
        if fs::read_dir(home).is_ok() {
            succeeded(home);
        }
    }
    for file in ["/etc/passwd", "/etc/shadow", "/etc/hostname", "/kit/Cargo.toml"] {
        if fs::read(file).is_ok() {
            succeeded(file);
        }
    }
}

fn writes() {
    for place in ["/", "/kit/", "/usr/", "/etc/", "/dev/", "/tmp/../kit/", "/lib/", "/proc/"] {
        if fs::write(format!("{place}escaped.rs"), "x").is_ok() {
            succeeded(place);
        }
    }
}

fn sockets() {
    if TcpStream::connect("1.1.1.1:53").is_ok() || TcpStream::connect("127.0.0.1:22").is_ok() {
        succeeded("a connection");
    }
    if "example.org:80".to_socket_addrs().is_ok() {
        succeeded("a name server");
    }
    let sent = UdpSocket::bind("0.0.0.0:0").and_then(|socket| socket.send_to(b"x", "1.1.1.1:53"));
    if sent.is_ok() {
        succeeded("a datagram");
    }
}

/// Whoever started this program is not to be seen, nor is what it knows.
fn parents() {
    let processes = fs::read_dir("/proc").into_iter().flatten().flatten();
    for process in processes {
        let Ok(number) = process.file_name().to_string_lossy().parse::<u32>() else { continue };
        for part in ["environ", "cmdline", "mem", "root/etc/passwd", "cwd/Cargo.toml"] {
            let Ok(bytes) = fs::read(process.path().join(part)) else { continue };
            let text = String::from_utf8_lossy(&bytes);
            if text.contains("CUTOFF_TEST_SECRET") || text.contains("grade\0") {
                succeeded(&format!("/proc/{number}/{part}"));
            }
        }
    }
    if std::env::var("CUTOFF_TEST_SECRET").is_ok() {
        succeeded("the environment");
    }
    // It is root of nothing.
    let mounted = Command::new("mount").args(["-t", "tmpfs", "none", "/tmp"]).output();
    if mounted.is_ok_and(|output| output.status.success()) {
        succeeded("mount");
    }
}

/// The disk is not there, and the room that is there is small.
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

/// It stays on those that it was given.
fn processors() {
    let own = std::process::id().to_string();
    let moved = Command::new("taskset").args(["-a", "-p", "-c", "0-63", &own]).output();
    if moved.is_ok_and(|output| output.status.success()) {
        succeeded("other processors");
    }
}

fn overwrites_itself() {
    let own = std::env::current_exe().unwrap_or_else(|_| "/kit/probe".into());
    if fs::write(&own, "x").is_ok() || fs::remove_file(&own).is_ok() {
        succeeded("another program in the place of this one");
    }
}
