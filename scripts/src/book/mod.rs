//! `cargo lab book`: the book, built.

use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail};
use clap::Args;

use crate::kit::Kit;

/// Build the book, or show it in a browser
#[derive(Args)]
pub(crate) struct Options {
    /// Build it anew whenever a page changes, and open it in the browser
    #[arg(long)]
    serve: bool,
}

/// Calls mdbook; its exit code becomes ours.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut mdbook = Command::new("mdbook");
    mdbook.arg(if options.serve { "serve" } else { "build" }).arg(kit.path("book"));
    if options.serve {
        mdbook.arg("--open");
    }
    match mdbook.status() {
        Ok(status) if status.success() => {
            if !options.serve {
                println!("The book is built: open book/build/index.html");
            }
            Ok(ExitCode::SUCCESS)
        }
        Ok(_) => Ok(ExitCode::FAILURE),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => {
            bail!("mdbook is not installed: scripts/setup.sh installs it")
        }
        Err(e) => Err(e).context("mdbook did not start"),
    }
}
