//! Grading a class: the instructors' commands of `cargo lab`.
//!
//! [`class`] is `cargo lab grade`. It takes in what was handed in ([`intake`]), builds it beside a
//! program that asks it ([`build`]) and runs it where it can do no harm ([`sandbox`]). Its answers are
//! judged outside ([`asking`]), and times are taken ([`timing`]). The result is a [`record`] of each
//! submission; the rubric and what the instructor says of the class ([`roll`]) make points of it
//! ([`score`]), and a [`report`] says so. [`regrade`], [`shell`] and [`similarity`] are
//! commands of their own.

mod asking;
mod build;
mod class;
mod escape;
mod intake;
mod record;
mod regrade;
mod report;
mod roll;
mod sandbox;
mod score;
mod shell;
mod similarity;
mod timing;

use std::panic;
use std::process::{ExitCode, exit};

use clap::Subcommand;

/// Grade a class, and compare what was handed in.
#[derive(Subcommand)]
enum Command {
    Grade(class::Options),
    Regrade(regrade::Options),
    Shell(shell::Options),
    Similarity(similarity::Options),
}

fn main() -> ExitCode {
    say_when_output_cannot_be_written();
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Grade(options) => class::run(kit, options),
        Command::Regrade(options) => regrade::run(kit, &options),
        Command::Shell(options) => shell::run(kit, &options),
        Command::Similarity(options) => similarity::run(kit, options),
    })
}

/// `println!` panics on a full disk. One line and exit code 2 say so instead.
fn say_when_output_cannot_be_written() {
    let usual = panic::take_hook();
    panic::set_hook(Box::new(move |panic| {
        let said = panic.payload_as_str().unwrap_or_default();
        let Some(why) = said.strip_prefix("failed printing to stdout: ") else {
            return usual(panic);
        };
        eprintln!("error: cannot write to standard output: {why}");
        exit(2);
    }));
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
