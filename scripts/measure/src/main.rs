//! The measuring commands of `cargo lab`.

use std::process::ExitCode;

use clap::Parser;
use lab_measure::commands::Command;

/// Time the labs' programs, and judge the times.
#[derive(Parser)]
#[command(name = "cargo lab", bin_name = "cargo lab")]
struct Options {
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, Options { command }| command.run(kit))
}

#[cfg(test)]
mod tests {
    use lab_kit::Kit;

    use super::Options;

    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        let kit = Kit::find().unwrap();
        let faults = lab_kit::command::faults::<Options>(&kit, env!("CARGO_PKG_NAME")).unwrap();
        assert!(faults.is_empty(), "{faults:#?}");
    }
}
