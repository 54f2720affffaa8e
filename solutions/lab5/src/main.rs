//! Runs lab 5: `mpiexec -n 2 target/release/solution5 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(solution5::VARIANTS)
}
