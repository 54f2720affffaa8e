//! How much a submission may have: time, memory, processes, room on a disk.

use std::time::Duration;

/// The longest times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Of a program.
    pub(crate) run: Duration,
    /// Of the compiler, for one submission.
    pub(crate) build: Duration,
}

/// What a process of a program may have.
pub(super) const PROGRAM: [&str; 5] =
    ["--nproc=256", "--fsize=67108864", "--core=0", "--nofile=256", "--as=4294967296"];

/// Bytes of memory of all processes of a submission together, however large the machine. See
/// [`super::memory`].
pub(super) const MEMORY_IN_ALL: u64 = 8 << 30;

/// Bytes of a program's own temporary files, and of memory that its ranks share.
pub(super) const TEMPORARY: &str = "67108864";
pub(super) const SHARED: &str = "134217728";

/// Bytes of the temporary files of a build.
pub(super) const BUILDS: &str = "1073741824";
