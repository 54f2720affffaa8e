//! The maintainers' commands of `cargo lab`.

use std::process::ExitCode;

use clap::Subcommand;
use lab_keep::{classroom, figures, handout, prove, starter};

/// Keep the kit true to itself, and hand it out.
#[derive(Subcommand)]
enum Command {
    Starter(starter::Options),
    Handout(handout::Options),
    Classroom(classroom::Options),
    Prove(prove::Options),
    Figures(figures::Options),
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Starter(options) => starter::run(kit, options),
        Command::Handout(options) => handout::run(kit, options),
        Command::Classroom(options) => classroom::run(kit, &options),
        Command::Prove(options) => prove::run(kit, options),
        Command::Figures(options) => figures::run(kit, options),
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
