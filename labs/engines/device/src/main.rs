//! Prints the name and the properties of this machine's device: `cargo run -p device`.

use std::process::ExitCode;

use device::Gpu;

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
