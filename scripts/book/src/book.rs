//! `cargo lab book`: the book, built and checked.
//!
//! mdBook hands each chapter to [`preprocess`]: markers are filled with hints and tables,
//! formulas become MathML, drawings become links to themselves, boxes that play get their scripts.
//! The check then looks at the sources ([`snippets`], [`reports`]) and at the pages that came out
//! ([`links`]).

use std::io;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail};
use clap::{Args, Subcommand};
use mdbook_preprocessor::book::BookItem;
use mdbook_preprocessor::parse_input;

use lab_kit::Kit;

use crate::{compare, figures, links, live, markers, math, reports, snippets};

/// Build the book, or show it in a browser
#[derive(Args)]
pub(crate) struct Options {
    /// Build it anew whenever a page changes, and open it in the browser
    #[arg(long)]
    serve: bool,
    /// Also look for broken links, snippets that show an answer, and tables of the course
    /// reports that are missing
    #[arg(long, conflicts_with = "serve")]
    check: bool,
}

/// What mdBook may ask a preprocessor before it hands over a book.
#[derive(Subcommand)]
pub(crate) enum Question {
    /// Whether it works for a renderer: yes, for any
    Supports {
        /// The renderer, such as `html`
        renderer: String,
    },
}

/// Calls mdbook; its exit code becomes ours.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let this = std::env::current_exe().context("this program's own file is not known")?;
    let mut mdbook = Command::new("mdbook");
    mdbook
        .arg(if options.serve { "serve" } else { "build" })
        .arg(kit.path("book"))
        // book.toml says how to start the preprocessor from nothing; here it is running already.
        .env(
            "MDBOOK_PREPROCESSOR__CUTOFF__COMMAND",
            format!("'{}' book-preprocess", this.display()),
        );
    if options.serve {
        mdbook.arg("--open");
    }
    match mdbook.status() {
        Ok(status) if status.success() => {}
        Ok(_) => return Ok(ExitCode::FAILURE),
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            bail!("mdbook is not installed: scripts/setup.sh installs it")
        }
        Err(e) => return Err(e).context("mdbook did not start"),
    }
    if options.check && !check(kit)? {
        return Ok(ExitCode::FAILURE);
    }
    if !options.serve {
        println!("The book is built: open book/build/index.html");
    }
    Ok(ExitCode::SUCCESS)
}

fn check(kit: &Kit) -> Result<bool> {
    let faults = [
        snippets::check(kit)?,
        reports::check(kit)?,
        compare::check(kit)?,
        links::check(&kit.path("book/build"))?,
    ]
    .concat();
    for fault in &faults {
        eprintln!("{fault}");
    }
    Ok(faults.is_empty())
}

/// Serves mdBook as a preprocessor: reads a book from the standard input, fills and renders what
/// only the kit knows, and writes the book to the standard output.
pub(crate) fn preprocess(kit: &Kit, question: Option<Question>) -> Result<ExitCode> {
    if let Some(Question::Supports { .. }) = question {
        return Ok(ExitCode::SUCCESS);
    }
    let (_, mut book) = parse_input(io::stdin())?;
    let mut result = Ok(());
    book.for_each_mut(|item| {
        if let (BookItem::Chapter(chapter), Ok(())) = (item, &result) {
            match markers::fill(kit, &chapter.content).and_then(|text| math::render(&text)) {
                Ok(text) => {
                    let path = chapter.path.as_deref().and_then(Path::parent);
                    let depth = path.map_or(0, |folder| folder.components().count());
                    chapter.content = live::scripts(figures::link(&text), depth);
                }
                Err(e) => result = Err(e.context(format!("chapter '{}'", chapter.name))),
            }
        }
    });
    result?;
    serde_json::to_writer(io::stdout(), &book)?;
    Ok(ExitCode::SUCCESS)
}
