//! Calls of the system that no program may make: a filter, which bubblewrap loads.
//!
//! - A program stays on the processors that it was given, and whatever it starts has the same ones.
//! - The kernel's keyrings belong to the user who started the grader: one program could leave a key for a later one.
//! - Memory that belongs to no process's addresses is in no limit.
//! - In a user namespace of its own a program would be root, and so much more of the kernel be in reach.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// An architecture's calls by number, as its kernel has them.
struct Calls {
    /// As filters call it.
    architecture: u32,
    /// `sched_setaffinity`; `add_key`, `request_key`, `keyctl`; `shmget`, `memfd_create`, `memfd_secret`;
    /// `setns`.
    refused: [u32; 8],
    /// `clone` and `unshare`, whose first argument says what is new.
    flagged: [u32; 2],
}

const CALLS: Option<Calls> = if cfg!(target_arch = "x86_64") {
    let refused = [203, 248, 249, 250, 29, 319, 447, 308];
    Some(Calls { architecture: 0xc000_003e, refused, flagged: [56, 272] })
} else if cfg!(target_arch = "aarch64") {
    let refused = [122, 217, 218, 219, 194, 279, 447, 268];
    Some(Calls { architecture: 0xc000_00b7, refused, flagged: [220, 97] })
} else {
    None
};

/// `clone3`, whose flags no filter can read. Who is told that there is none takes `clone`.
const CLONE3: u32 = 435;

/// The flag of a new user namespace.
const NEW_USER: u32 = 0x1000_0000;

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
    let (load, equal, not_less, has, end) = (0x20, 0x15, 0x35, 0x45, 0x06);
    let (number, architecture, first_argument) = (0, 4, 16);
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
    begin.into_iter().chain(refused).chain(flagged).chain([(end, 0, 0, allowed)])
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::{CALLS, program};

    /// What a filter says to a call.
    fn verdict(call: u32, flags: u32) -> u32 {
        let calls = CALLS.unwrap();
        let data = [call, calls.architecture, 0, 0, flags];
        let program: Vec<_> = program(&calls).collect();
        let (mut at, mut word) = (0, 0);
        loop {
            let (code, yes, no, number) = program[at];
            let holds = match code {
                0x20 => {
                    word = data[number as usize / 4];
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
        assert_eq!([0, 1, 63].map(|call| verdict(call, super::NEW_USER)), [allowed; 3]);
        assert_eq!(verdict(super::CLONE3, 0), 0x0005_0026);
    }
}
