//! Runs lab 6: `mpiexec -n 2 target/release/lab6 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(lab6::VARIANTS)
}
