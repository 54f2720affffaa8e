//! The `cargo lab` command: the students' commands, and the [door] to the others.

mod calls;
mod check;
mod door;
mod graded;
mod hint;
mod json;
mod list;
mod memory;
mod movie;
mod print_facts;
mod report;
mod reset;
mod results;
mod run;
mod submit;
mod tasks;
mod test;
mod version;
mod watch;

use std::process::ExitCode;

use clap::{FromArgMatches, Subcommand};
use lab_kit::{Kit, command};

/// Cutoff's labs: test them, get hints, run them, measure them.
#[derive(Subcommand)]
enum Command {
    List(list::Options),
    Test(test::Options),
    Watch(watch::Options),
    Hint(hint::Options),
    Check(check::Options),
    Submit(submit::Options),
    Reset(reset::Options),
    Run(run::Options),
    Movie(movie::Options),
    #[command(hide = true)]
    Facts,
}

fn main() -> ExitCode {
    command::end_in_one_line();
    command::finish(Kit::find().and_then(|kit| {
        if std::env::args().nth(1).is_some_and(|word| word == "--version" || word == "-V") {
            print!("{}", version::version(&kit));
            return Ok(ExitCode::SUCCESS);
        }
        if let Some(code) = door::elsewhere(&kit)? {
            return Ok(code);
        }
        let matches = door::command::<Command>(&kit)?.get_matches();
        match Command::from_arg_matches(&matches).unwrap_or_else(|e| e.exit()) {
            Command::List(options) => list::run(&kit, options),
            Command::Test(options) => test::run(&kit, options),
            Command::Watch(options) => watch::run(&kit, options),
            Command::Hint(options) => hint::run(&kit, options),
            Command::Check(options) => check::run(&kit, options),
            Command::Submit(options) => submit::run(&kit, options),
            Command::Reset(options) => reset::run(&kit, options),
            Command::Run(options) => run::run(&kit, options),
            Command::Movie(options) => movie::run(&kit, options),
            Command::Facts => print_facts::run(&kit),
        }
    }))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
