//! No program leaves the processors that it was given: a filter of system calls, which bubblewrap loads,
//! refuses to change them.
//!
//! A program's processors are set before it starts, and whatever it starts has the same ones. So
//! nobody has to find out afterwards how much was computed elsewhere, by whom, and whether that still lives.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The architecture as the kernel's filters call it, and its number of `sched_setaffinity`.
const CALL: Option<(u32, u32)> = if cfg!(target_arch = "x86_64") {
    Some((0xc000_003e, 203))
} else if cfg!(target_arch = "aarch64") {
    Some((0xc000_00b7, 122))
} else {
    None
};

/// Numbers from here on are of the other calls that x86-64 has, with shorter pointers.
const X32: u32 = 0x4000_0000;

/// Writes the filter into a folder. None on an architecture whose calls are not known here.
pub(super) fn write_filter(folder: &Path) -> io::Result<Option<PathBuf>> {
    let Some((architecture, call)) = CALL else { return Ok(None) };
    // A small machine's program: load a word, jump so many instructions if it is equal (or not less), or
    // not, return.
    let (load, equal, not_less, give) = (0x20_u16, 0x15, 0x35, 0x06);
    let (allow, refuse) = (0x7fff_0000, 0x0005_0001);
    let program: [(u16, u8, u8, u32); 7] = [
        (load, 0, 0, 4),
        (equal, 0, 4, architecture),
        (load, 0, 0, 0),
        (not_less, 2, 0, X32),
        (equal, 1, 0, call),
        (give, 0, 0, allow),
        (give, 0, 0, refuse),
    ];
    let instruction = |(code, yes, no, word): (u16, u8, u8, u32)| {
        let ([a, b], [c, d, e, f]) = (code.to_ne_bytes(), word.to_ne_bytes());
        [a, b, yes, no, c, d, e, f]
    };
    let path = folder.join("affinity.bpf");
    fs::write(&path, program.map(instruction).as_flattened())?;
    Ok(Some(path))
}
