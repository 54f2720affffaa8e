//! Calls of the system that no program may make: a filter, which bubblewrap loads.
//!
//! - A program stays on the processors that it was given, and whatever it starts has the same ones.
//! - The kernel's keyrings belong to the user who started the grader: one program could leave a key for a later one.
//! - Memory that belongs to no process's addresses is in no limit: that of files without a name, of System V's segments,
//!   semaphores and queues, of mappings without a file that are shared (who has looked at them once and lets go of the
//!   pages holds them still), and in the buffers of sockets, which stay as long as the system makes them.
//! - In a user namespace of its own a program would be root, and so much more of the kernel be in reach.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// An architecture's calls by number, as its kernel has them.
struct Calls {
    /// As filters call it.
    architecture: u32,
    /// `sched_setaffinity`; `add_key`, `request_key`, `keyctl`; `shmget`, `semget`, `msgget`, `memfd_create`,
    /// `memfd_secret`; `setns`.
    refused: [u32; 10],
    /// `clone` and `unshare`, whose first argument says what is new.
    flagged: [u32; 2],
    /// `mmap`, whose fourth argument says whether it is shared and of a file; `setsockopt`.
    mmap: u32,
    setsockopt: u32,
}

const CALLS: Option<Calls> = if cfg!(target_arch = "x86_64") {
    let refused = [203, 248, 249, 250, 29, 64, 68, 319, 447, 308];
    Some(Calls { architecture: 0xc000_003e, refused, flagged: [56, 272], mmap: 9, setsockopt: 54 })
} else if cfg!(target_arch = "aarch64") {
    let refused = [122, 217, 218, 219, 194, 190, 186, 279, 447, 268];
    Some(Calls {
        architecture: 0xc000_00b7,
        refused,
        flagged: [220, 97],
        mmap: 222,
        setsockopt: 208,
    })
} else {
    None
};

/// `clone3`, whose flags no filter can read. Who is told that there is none takes `clone`.
const CLONE3: u32 = 435;

/// The flag of a new user namespace.
const NEW_USER: u32 = 0x1000_0000;

/// The flags of a mapping that is shared, and of no file.
const SHARED_WITHOUT_FILE: u32 = 0x21;

/// The option of a socket's buffer for what is sent.
const SEND_BUFFER: u32 = 7;

/// Numbers from here on are of the other calls that x86-64 has, with shorter pointers.
const X32: u32 = 0x4000_0000;

/// An instruction of the kernel's filters: what it does, how many instructions it jumps over if so and if
/// not, and a number.
type Instruction = (u16, u8, u8, u32);

/// Writes the filter into a folder. None on an architecture whose calls are not known here.
pub(super) fn write(folder: &Path) -> io::Result<Option<PathBuf>> {
    let Some(calls) = CALLS else { return Ok(None) };
    let bytes = |(code, yes, no, word): Instruction| {
        let ([a, b], [c, d, e, f]) = (code.to_ne_bytes(), word.to_ne_bytes());
        [a, b, yes, no, c, d, e, f]
    };
    let path = folder.join("calls.bpf");
    fs::write(&path, program(&calls).map(bytes).collect::<Vec<_>>().as_flattened())?;
    Ok(Some(path))
}

fn program(calls: &Calls) -> impl Iterator<Item = Instruction> {
    let (load, equal, not_less, has, and, end) = (0x20, 0x15, 0x35, 0x45, 0x54, 0x06);
    let (number, architecture, first_argument, third_argument, fourth_argument) =
        (0, 4, 16, 32, 40);
    let (allowed, not_permitted, not_there) = (0x7fff_0000, 0x0005_0001, 0x0005_0026);
    let is = move |call| (equal, 0, 1, call);
    let refuse = (end, 0, 0, not_permitted);
    let begin = [
        (load, 0, 0, architecture),
        (equal, 1, 0, calls.architecture),
        refuse,
        (load, 0, 0, number),
        (not_less, 0, 1, X32),
        refuse,
        is(CLONE3),
        (end, 0, 0, not_there),
    ];
    let refused = calls.refused.into_iter().flat_map(move |call| [is(call), refuse]);
    let flagged = calls.flagged.into_iter().flat_map(move |call| {
        let flags = [(load, 0, 0, first_argument), (has, 0, 1, NEW_USER), refuse];
        // Over the four that follow, if it is another call: the number is still loaded.
        [(equal, 0, 4, call)].into_iter().chain(flags).chain([(end, 0, 0, allowed)])
    });
    let memory = [
        (equal, 0, 5, calls.mmap),
        (load, 0, 0, fourth_argument),
        (and, 0, 0, SHARED_WITHOUT_FILE),
        (equal, 0, 1, SHARED_WITHOUT_FILE),
        refuse,
        (end, 0, 0, allowed),
        (equal, 0, 3, calls.setsockopt),
        (load, 0, 0, third_argument),
        (equal, 0, 1, SEND_BUFFER),
        refuse,
    ];
    begin.into_iter().chain(refused).chain(flagged).chain(memory).chain([(end, 0, 0, allowed)])
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::{CALLS, program};

    /// What a filter says to a call with one argument that is not 0, the first or another.
    fn verdict(call: u32, flags: u32) -> u32 {
        verdict_on(call, 0, flags)
    }

    fn verdict_on(call: u32, which: usize, argument: u32) -> u32 {
        let calls = CALLS.unwrap();
        let mut data = [call, calls.architecture, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        data[4 + 2 * which] = argument;
        let program: Vec<_> = program(&calls).collect();
        let (mut at, mut word) = (0, 0);
        loop {
            let (code, yes, no, number) = program[at];
            let holds = match code {
                0x20 => {
                    word = data[number as usize / 4];
                    false
                }
                0x54 => {
                    word &= number;
                    false
                }
                0x15 => word == number,
                0x35 => word >= number,
                0x45 => word & number != 0,
                _ => return number,
            };
            at += 1 + usize::from(if holds { yes } else { no });
        }
    }

    #[test]
    fn calls_are_refused_and_threads_and_programs_start() {
        let (allowed, not_permitted) = (0x7fff_0000, 0x0005_0001);
        let calls = CALLS.unwrap();
        for call in calls.refused.into_iter().chain([super::X32]) {
            assert_eq!(verdict(call, 0), not_permitted, "{call}");
        }
        for call in calls.flagged {
            assert_eq!(verdict(call, super::NEW_USER | 17), not_permitted);
            assert_eq!(verdict(call, 17), allowed);
        }
        // Shared without a file, validated or not; private, or of a file.
        for (flags, says) in [(0x21, not_permitted), (0x4023, not_permitted), (0x22, allowed)] {
            assert_eq!(verdict_on(calls.mmap, 3, flags), says);
        }
        assert_eq!(verdict_on(calls.mmap, 3, 1), allowed);
        assert_eq!(verdict_on(calls.setsockopt, 2, 7), not_permitted);
        assert_eq!(verdict_on(calls.setsockopt, 2, 2), allowed);
        assert_eq!([0, 1, 63].map(|call| verdict(call, super::NEW_USER)), [allowed; 3]);
        assert_eq!(verdict(super::CLONE3, 0), 0x0005_0026);
    }
}
