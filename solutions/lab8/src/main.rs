//! Runs lab 8: `mpiexec -n 2 target/release/solution8 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive_hard(solution8::VARIANTS)
}
