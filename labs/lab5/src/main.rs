//! Runs lab 5: `mpiexec -n 2 target/release/lab5 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(lab5::VARIANTS)
}
