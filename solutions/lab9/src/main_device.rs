//! Which device lab 9 runs on: `cargo run --release -p lab9 --bin lab9-device`.

use std::process::ExitCode;

use solution9::gpu::Gpu;

fn main() -> ExitCode {
    match Gpu::shared() {
        Ok(gpu) => {
            println!("{}", gpu.name());
            for (what, value) in gpu.about() {
                println!("  {what:17} {value}");
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
