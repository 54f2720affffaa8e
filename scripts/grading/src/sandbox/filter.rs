//! Filter of system calls that no program may make. Bubblewrap loads it.
//!
//! - A program and its child processes stay on the processors that the grader gave them.
//! - The kernel's keyrings belong to the user who started the grader. A program could leave a key
//!   there for a later program.
//! - No limit counts memory outside the address space of a process.
//! - In its own user namespace a program would be root, with access to much more of the kernel.
//! - Connections are refused to programs that do not need them, because no limit counts unread data
//!   in a connection.
//! - No program may change or watch a running process: neither its own memory through the kernel,
//!   nor another process.
//!
//! A refused call fails as if this kernel did not support it.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;

/// Writes the filter into a folder. With `loopback`, programs may connect to each other.
#[cfg(target_os = "linux")]
pub(super) fn write(folder: &Path, loopback: bool) -> Result<Option<PathBuf>> {
    let path = folder.join("calls.bpf");
    let instructions = program(loopback)?.into_iter().map(|it| {
        let ([a, b], [c, d, e, f]) = (it.code.to_ne_bytes(), it.k.to_ne_bytes());
        [a, b, it.jt, it.jf, c, d, e, f]
    });
    fs::write(&path, instructions.collect::<Vec<_>>().as_flattened())?;
    Ok(Some(path))
}

#[cfg(target_os = "linux")]
fn program(loopback: bool) -> Result<seccompiler::BpfProgram> {
    use libc::{SYS_add_key, SYS_keyctl, SYS_memfd_create, SYS_memfd_secret, SYS_request_key};
    use libc::{SYS_bpf, SYS_kcmp, SYS_perf_event_open, SYS_pidfd_getfd, SYS_userfaultfd};
    use libc::{SYS_clone, SYS_clone3, SYS_sched_setaffinity, SYS_setns, SYS_unshare};
    use libc::{SYS_io_uring_setup, SYS_process_vm_readv, SYS_process_vm_writev, SYS_ptrace};
    use libc::{SYS_mmap, SYS_msgget, SYS_semget, SYS_setsockopt, SYS_shmget, SYS_socket};
    use seccompiler::SeccompAction::{Allow, Errno};
    use seccompiler::SeccompCmpOp::{Eq, MaskedEq, Ne};
    use seccompiler::{SeccompCmpArgLen, SeccompCondition, SeccompFilter, SeccompRule};

    // The numbers from here up belong to x32, the second set of system calls of x86-64.
    const X32: libc::c_long = 0x4000_0000;
    let refused = [
        SYS_io_uring_setup,
        SYS_process_vm_readv,
        SYS_process_vm_writev,
        SYS_ptrace,
        SYS_bpf,
        SYS_kcmp,
        SYS_perf_event_open,
        SYS_pidfd_getfd,
        SYS_userfaultfd,
        SYS_sched_setaffinity,
        SYS_add_key,
        SYS_request_key,
        SYS_keyctl,
        SYS_shmget,
        SYS_semget,
        SYS_msgget,
        SYS_memfd_create,
        SYS_memfd_secret,
        SYS_setns,
        // A filter cannot read the flags of `clone3`, so this call is reported as missing.
        // Programs then call `clone` instead.
        SYS_clone3,
    ];
    // Refuses a call if `comparison` holds between argument `at` (counted from 0) and `number`.
    let if_argument = |at, comparison, number| -> Result<_> {
        let condition = SeccompCondition::new(at, SeccompCmpArgLen::Dword, comparison, number)?;
        Ok(vec![SeccompRule::new(vec![condition])?])
    };
    let new_user = libc::CLONE_NEWUSER as u64;
    let flagged = if_argument(0, MaskedEq(new_user), new_user)?;
    let without_file = (libc::MAP_SHARED | libc::MAP_ANONYMOUS) as u64;
    let mut conditional = vec![
        (SYS_clone, flagged.clone()),
        (SYS_unshare, flagged),
        (SYS_mmap, if_argument(3, MaskedEq(without_file), without_file)?),
        (SYS_setsockopt, if_argument(2, Eq, libc::SO_SNDBUF as u64)?),
    ];
    if !loopback {
        conditional.push((SYS_socket, if_argument(0, Ne, libc::AF_UNIX as u64)?));
    }
    let rules = refused.map(|call| (call, Vec::new())).into_iter().chain(conditional);
    let rules = rules.flat_map(|(call, rules)| [(call, rules.clone()), (call | X32, rules)]);
    let architecture = std::env::consts::ARCH.try_into()?;
    let filter =
        SeccompFilter::new(rules.collect(), Allow, Errno(libc::ENOSYS as u32), architecture)?;
    Ok(filter.try_into()?)
}

/// Writes no filter, because only Linux has such filters.
#[cfg(not(target_os = "linux"))]
pub(super) fn write(_folder: &Path, _loopback: bool) -> Result<Option<PathBuf>> {
    Ok(None)
}
