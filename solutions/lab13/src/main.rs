//! Runs lab 13: `mpiexec -n 2 target/release/solution13 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(solution13::VARIANTS)
}
