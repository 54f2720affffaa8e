//! Runs lab 8: `mpiexec -n 2 target/release/lab8 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive_hard(lab8::VARIANTS)
}
