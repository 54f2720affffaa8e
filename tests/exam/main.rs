//! `cargo lab exam`: draws a paper for an examination, and its key.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use clap::{Args, Subcommand};
use exam::paper;
use lab_kit::files::write_file;
use lab_kit::{Kit, Lab};

/// Set an examination.
#[derive(Subcommand)]
enum Command {
    Exam(Options),
}

/// Draw an examination paper and its key (for instructors)
///
/// Papers of different seeds have different questions and numbers, the same kinds of questions, and the same number of
/// points.
#[derive(Args)]
struct Options {
    /// Draws questions and numbers; the same seed gives the same paper
    #[arg(long, value_name = "N")]
    seed: u64,
    /// The labs that the questions are about [default: all]
    #[arg(long, value_delimiter = ',', value_name = "N,N")]
    labs: Vec<Lab>,
    /// The folder of the two files; target/lab/exam if not given
    #[arg(long, value_name = "DIR")]
    into: Option<PathBuf>,
}

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| match command {
        Command::Exam(options) => run(kit, options),
    })
}

/// Writes the paper and the key.
fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let Options { seed, labs, into } = options;
    let labs = if labs.is_empty() { kit.solutions() } else { labs };
    let paper = paper::draw(kit, &labs, seed)?;
    let into = into.unwrap_or_else(|| kit.memory().join("exam"));
    for (name, text) in [("paper", paper.questions), ("key", paper.key)] {
        let file = into.join(format!("{name}-{seed}.md"));
        write_file(&file, text)?;
        println!("{}", file.display());
    }
    Ok(ExitCode::SUCCESS)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<super::Command>(env!("CARGO_PKG_NAME"));
    }
}
