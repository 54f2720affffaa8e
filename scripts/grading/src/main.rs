//! Grading a class: the instructors' commands of `cargo lab`.

mod grade;
mod similarity;
mod submission;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::grade::{difference, regrade};

/// Grade a class, and compare what was handed in.
#[derive(Parser)]
#[command(name = "cargo lab", bin_name = "cargo lab")]
struct Options {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Grade(grade::Options),
    Regrade(regrade::Options),
    GradeDiff(difference::Options),
    Similarity(similarity::Options),
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, Options { command }| match command {
        Command::Grade(options) => grade::run(kit, options),
        Command::Regrade(options) => regrade::run(kit, &options),
        Command::GradeDiff(options) => difference::run(&options),
        Command::Similarity(options) => similarity::run(kit, options),
    })
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
