//! `cargo lab book`: builds the book and checks it.
//!
//! mdBook hands each chapter to the [preprocessor](crate::preprocessor). The checks read the
//! sources ([`snippets`], [`sections`], [`printed`], [`reports`], [`variants`], [`locations`],
//! [`glossary`]), and lychee reads the built pages.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::{env, fs, io};

use anyhow::{Context, Result, bail};
use clap::Args;

use lab_kit::{Kit, system};

use crate::entries::Data;
use crate::pages::pages;
use crate::preprocessor::WITHOUT_HINTS;
use crate::{glossary, locations, markers, printed, reports, sections, snippets, variants};

/// Build the book, or show it in a browser
#[derive(Args)]
pub(crate) struct Options {
    /// Build the book again whenever a page changes, and open it in the browser
    #[arg(long)]
    serve: bool,
    /// Also check the book. It finds broken links, snippets that show an answer, sections that a
    /// starter names and no chapter has, typed tables of measurements, variants without a row in
    /// the comparison, words of the glossary that their section lacks, and missing tables of the
    /// course reports
    #[arg(long, conflicts_with = "serve")]
    check: bool,
}

/// Runs mdbook. Its exit code is the exit code of the command.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    if options.serve {
        let served = succeeds(mdbook(kit, "serve")?.arg("--open"))?;
        return Ok(if served { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    if !build(kit)? {
        return Ok(ExitCode::FAILURE);
    }
    if options.check && !check(kit)? {
        return Ok(ExitCode::FAILURE);
    }
    println!("The book is built: open book/build/index.html");
    Ok(ExitCode::SUCCESS)
}

fn mdbook(kit: &Kit, what: &str) -> Result<Command> {
    let this = env::current_exe().context("this program's own file is not known")?;
    let mut mdbook = Command::new("mdbook");
    // The command in book.toml would build the preprocessor first, but it is built already.
    let preprocessor = format!("'{}' book-preprocess", this.display());
    mdbook.arg(what).arg(kit.path("book"));
    mdbook.env("MDBOOK_PREPROCESSOR__CUTOFF__COMMAND", preprocessor);
    Ok(mdbook)
}

fn succeeds(mdbook: &mut Command) -> Result<bool> {
    Ok(start(mdbook)?.wait()?.success())
}

fn start(mdbook: &mut Command) -> Result<Child> {
    match mdbook.spawn() {
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            bail!("mdbook is not installed: scripts/setup.sh installs it")
        }
        child => child.context("mdbook did not start"),
    }
}

/// Builds the book. Its search index comes from a second book, without hints.
///
/// So a search does not show an answer that the book hides in a fold. The two books are built at
/// the same time.
fn build(kit: &Kit) -> Result<bool> {
    let folder = tempfile::tempdir()?;
    let mut without = mdbook(kit, "build")?;
    without.arg("--dest-dir").arg(folder.path()).env(WITHOUT_HINTS, "");
    without.env("MDBOOK_OUTPUT__HTML__PRINT__ENABLE", "false");
    without.stdout(Stdio::null()).stderr(Stdio::null());
    let mut without = start(&mut without)?;
    let built = succeeds(&mut mdbook(kit, "build")?)?;
    let indexed = without.wait()?.success();
    if !built {
        return Ok(false);
    }
    if !indexed {
        bail!("the book without hints cannot be built");
    }
    // The index's name contains a hash, which has to change only if the contents change.
    fs::copy(index(folder.path())?, index(&kit.path("book/build"))?)?;
    Ok(true)
}

/// Returns the search index of a built book.
fn index(folder: &Path) -> Result<PathBuf> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("searchindex") && name.ends_with(".js") {
            return Ok(path);
        }
    }
    bail!("{} has no search index", folder.display())
}

fn check(kit: &Kit) -> Result<bool> {
    let mut data = Data::new(kit);
    let mut filled = pages(kit)?;
    for text in filled.values_mut() {
        *text = markers::fill(&mut data, text)?;
    }
    // If the labs' programs are built, they are in the folder of this program.
    let this = env::current_exe()?;
    let faults = [
        snippets::check(kit)?,
        sections::check(kit)?,
        printed::check(kit)?,
        reports::check(&mut data, &filled)?,
        variants::check(&mut data, this.parent().unwrap_or(Path::new("")))?,
        locations::check(kit)?,
        glossary::check(kit)?,
    ]
    .concat();
    for fault in &faults {
        eprintln!("{fault}");
    }
    Ok(links_lead_somewhere(&kit.path("book/build"))? && faults.is_empty())
}

/// Runs lychee, if it is installed, to check that all links inside the built book lead to a page.
fn links_lead_somewhere(build: &Path) -> Result<bool> {
    if !system::on_path("lychee".as_ref()) {
        println!("left out: links, for there is no lychee");
        return Ok(true);
    }
    let mut lychee = Command::new("lychee");
    lychee.args(["--offline", "--include-fragments", "--no-progress", "--root-dir"]);
    let output = lychee.arg(build).arg(build).output().context("lychee did not start")?;
    if !output.status.success() {
        eprint!("{}", String::from_utf8_lossy(&output.stdout));
    }
    Ok(output.status.success())
}
