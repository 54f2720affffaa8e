//! What the book's findings rest on: the research commands of `cargo lab`.

mod chosen;
mod figures;
mod forecast;
mod greedy;
mod lammps;
mod model;
mod precision;
mod reported;
mod stress;

use std::process::ExitCode;

use clap::Subcommand;

/// Look behind the labs' results, for the book.
#[derive(Subcommand)]
enum Command {
    Precision(precision::Options),
    Stress(stress::Options),
    Lammps(lammps::Options),
    Model(model::Options),
    Forecast(forecast::Options),
    Greedy(greedy::Options),
    Reported(reported::Options),
    Figures(figures::Options),
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Precision(options) => precision::run(kit, options),
        Command::Stress(options) => stress::run(kit, options),
        Command::Lammps(options) => lammps::run(kit, options),
        Command::Model(options) => model::run(kit, &options),
        Command::Forecast(options) => forecast::run(kit, &options),
        Command::Greedy(options) => greedy::run(&options),
        Command::Reported(options) => reported::run(&options),
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
