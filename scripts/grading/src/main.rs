//! Grades a class: the instructors' commands of `cargo lab`.
//!
//! [`class`] is `cargo lab grade`. It reads submissions ([`submission`]) and builds each of them
//! together with a program that asks it questions ([`build`]). The program runs in a sandbox
//! ([`sandbox`]). The answers are judged outside the sandbox ([`asking`]), and times are taken
//! ([`timing`]). The result is a [`record`] of each submission. Points are computed from the
//! record, the rubric and the instructor's `class.toml` ([`roster`], [`score`]), and a [`report`]
//! shows them. [`regrade`], [`shell`], [`similarity`] and [`viva`] are separate commands.

mod asking;
mod build;
mod class;
mod record;
mod regrade;
mod report;
mod roster;
mod sandbox;
mod score;
mod shell;
mod similarity;
mod submission;
mod timing;
mod viva;

use std::process::ExitCode;

use clap::Subcommand;

/// Grade a class, compare what was handed in, and ask about it.
#[derive(Subcommand)]
enum Command {
    Grade(class::Options),
    Regrade(regrade::Options),
    Shell(shell::Options),
    Similarity(similarity::Options),
    Viva(viva::Options),
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Grade(options) => class::run(kit, options),
        Command::Regrade(options) => regrade::run(kit, &options),
        Command::Shell(options) => shell::run(kit, &options),
        Command::Similarity(options) => similarity::run(kit, options),
        Command::Viva(options) => viva::run(kit, &options),
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
