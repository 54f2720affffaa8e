//! The `cargo lab` command: everything around the labs that is not the labs.
//!
//! One command, one file; a family of commands, one folder. What several of them share:
//! [`kit`] knows where things are; [`marks`] what a task's answer is; [`harness`]
//! runs tests; [`measure`] times programs
//! and draws what comes out.
//!
//! Exit codes, for scripts: 0 if all is well, 1 if the answer is no (a test failed, a file has
//! drifted), 2 if there was no answer (a bad command line, a missing file).

mod book;
mod complexity;
mod digest;
mod figures;
mod grade;
mod greedy;
mod handout;
mod harness;
mod hints;
mod kit;
mod lammps;
mod marks;
mod measure;
mod model;
mod movie;
mod precision;
mod prove;
mod race;
mod run;
mod scaling;
mod similarity;
mod starter;
mod stress;
mod student;
mod submission;
mod sweep;
mod system;
mod traffic;
mod yardstick;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::kit::Kit;
use crate::student::{check, hint, list, progress, reset, submit, test, watch};

/// Cutoff's labs: test them, get hints, run them, measure them.
#[derive(Parser)]
#[command(name = "cargo lab", bin_name = "cargo lab")]
struct Options {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    List(list::Options),
    Progress(progress::Options),
    Test(test::Options),
    Watch(watch::Options),
    Hint(hint::Options),
    Check(check::Options),
    Submit(submit::Options),
    Reset(reset::Options),
    Run(run::Options),
    Movie(movie::Options),
    Race(race::Options),
    Complexity(complexity::Options),
    Scaling(scaling::Options),
    Sweep(sweep::Options),
    Traffic(traffic::Options),
    Model(model::Options),
    Yardstick(yardstick::Options),
    Book(book::Options),
    Figures(figures::Options),
    Grade(grade::Options),
    Regrade(grade::regrade::Options),
    GradeDiff(grade::difference::Options),
    Greedy(greedy::Options),
    Precision(precision::Options),
    Stress(stress::Options),
    Lammps(lammps::Options),
    Starter(starter::Options),
    Handout(handout::Options),
    Similarity(similarity::Options),
    /// Serve mdBook as a preprocessor (book.toml calls this)
    #[command(hide = true)]
    BookPreprocess {
        #[command(subcommand)]
        question: Option<book::Question>,
    },
    Prove(prove::Options),
}

/// `head` and `less` close the pipe when they have seen enough: that is no error, and `println!`
/// would panic.
fn end_quietly_when_nobody_reads() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let said = panic.payload().downcast_ref::<String>();
        let unread = |text: &String| {
            text.starts_with("failed printing to stdout") && text.contains("Broken pipe")
        };
        if said.is_some_and(unread) {
            std::process::exit(0);
        }
        usual(panic);
    }));
}

fn main() -> ExitCode {
    end_quietly_when_nobody_reads();
    let Options { command } = Options::parse();
    let result = Kit::find().and_then(|kit| match command {
        Command::List(options) => list::run(&kit, options),
        Command::Progress(options) => progress::run(&kit, options),
        Command::Watch(options) => watch::run(&kit, options),
        Command::Submit(options) => submit::run(&kit, options),
        Command::Similarity(options) => similarity::run(&kit, options),
        Command::Test(options) => test::run(&kit, options),
        Command::Hint(options) => hint::run(&kit, options),
        Command::Check(options) => check::run(&kit, options),
        Command::Reset(options) => reset::run(&kit, options),
        Command::Run(options) => run::run(&kit, options),
        Command::Movie(options) => movie::run(&kit, options),
        Command::Race(options) => race::run(&kit, options),
        Command::Complexity(options) => complexity::run(&kit, options),
        Command::Scaling(options) => scaling::run(&kit, options),
        Command::Sweep(options) => sweep::run(&kit, options),
        Command::Traffic(options) => traffic::run(&kit, options),
        Command::Model(options) => model::run(&kit, &options),
        Command::Yardstick(options) => yardstick::run(&options),
        Command::Book(options) => book::run(&kit, options),
        Command::Figures(options) => figures::run(&kit, options),
        Command::Grade(options) => grade::run(&kit, options),
        Command::Regrade(options) => grade::regrade::run(&kit, &options),
        Command::GradeDiff(options) => grade::difference::run(&options),
        Command::Greedy(options) => greedy::run(&options),
        Command::Precision(options) => precision::run(&kit, options),
        Command::Lammps(options) => lammps::run(&kit, options),
        Command::Stress(options) => stress::run(&kit, options),
        Command::Handout(options) => handout::run(&kit, options),
        Command::Starter(options) => starter::run(&kit, options),
        Command::BookPreprocess { question } => book::preprocess(&kit, question),
        Command::Prove(options) => prove::run(&kit, options),
    });
    result.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::from(2)
    })
}
