//! The book: `cargo lab book`, and the preprocessor that mdBook calls.

mod book;
mod compare;
mod ending;
mod figures;
mod glossary;
mod hints;
mod labs;
mod locations;
mod markers;
mod math;
mod pages;
mod parts;
mod reports;
mod sections;
mod snippets;
mod tables;

use std::process::ExitCode;

use clap::Subcommand;

/// Build the book.
#[derive(Subcommand)]
enum Command {
    Book(book::Options),
    /// Serve mdBook as a preprocessor (book.toml calls this)
    #[command(hide = true)]
    BookPreprocess,
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Book(options) => book::run(kit, options),
        Command::BookPreprocess => book::preprocess(kit),
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
