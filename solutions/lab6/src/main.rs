//! Runs lab 6: `mpiexec -n 2 target/release/solution6 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(solution6::VARIANTS)
}
