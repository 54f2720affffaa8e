//! The book: `cargo lab book`, and the preprocessor that mdBook calls.

mod alignment;
mod chapter_tasks;
mod digits;
mod drawings;
mod ending;
mod entries;
mod glossary;
mod labs;
mod locations;
mod markers;
mod math;
mod mdbook;
mod pages;
mod plot;
mod predictions;
mod preprocessor;
mod printed;
mod query;
mod reports;
mod sections;
mod snippets;
mod understanding;
mod variants;

use std::process::ExitCode;

use clap::Subcommand;

/// Build the book
#[derive(Subcommand)]
enum Command {
    Book(mdbook::Options),
    /// Serve mdBook as a preprocessor (book.toml calls this)
    #[command(hide = true)]
    BookPreprocess,
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Book(options) => mdbook::run(kit, options),
        Command::BookPreprocess => preprocessor::run(kit),
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
