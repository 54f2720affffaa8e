//! `cargo lab book`: the book, built and checked.
//!
//! mdBook hands each chapter to [`preprocess`]: markers are filled with hints and tables,
//! formulas become MathML, drawings become links to themselves, boxes that play get their scripts, pages get a foot.
//! The check then looks at the sources ([`snippets`], [`sections`], [`reports`], [`compare`],
//! [`parts`], [`locations`], [`tables`], [`glossary`]), and lychee at the links of the pages that came out.

use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{env, fs, io};

use anyhow::{Context, Result, bail};
use clap::Args;
use mdbook_preprocessor::book::{BookItem, Chapter};
use mdbook_preprocessor::parse_input;

use lab_kit::{Kit, system};

use crate::{
    compare, ending, figures, glossary, hints, locations, markers, math, parts, reports, sections,
    snippets, tables,
};

/// Build the book, or show it in a browser
#[derive(Args)]
pub(crate) struct Options {
    /// Build it anew whenever a page changes, and open it in the browser
    #[arg(long)]
    serve: bool,
    /// Also look for broken links, snippets that show an answer, sections that a starter names and no
    /// chapter has, numbers that are not in their data, chapters without one of their parts, words of the
    /// glossary that their section lacks, and tables of the course reports that are missing
    #[arg(long, conflicts_with = "serve")]
    check: bool,
}

/// Set where the preprocessor is to leave the hints out.
const WITHOUT_HINTS: &str = "CUTOFF_BOOK_WITHOUT_HINTS";

/// Calls mdbook; its exit code becomes ours.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut mdbook = mdbook(kit, if options.serve { "serve" } else { "build" })?;
    if options.serve {
        mdbook.arg("--open");
    }
    if !succeeds(&mut mdbook)? {
        return Ok(ExitCode::FAILURE);
    }
    if options.serve {
        return Ok(ExitCode::SUCCESS);
    }
    index_without_hints(kit)?;
    if options.check && !check(kit)? {
        return Ok(ExitCode::FAILURE);
    }
    println!("The book is built: open book/build/index.html");
    Ok(ExitCode::SUCCESS)
}

fn mdbook(kit: &Kit, what: &str) -> Result<Command> {
    let this = env::current_exe().context("this program's own file is not known")?;
    let mut mdbook = Command::new("mdbook");
    // book.toml says how to start the preprocessor from nothing; here it is running already.
    let preprocessor = format!("'{}' book-preprocess", this.display());
    mdbook.arg(what).arg(kit.path("book"));
    mdbook.env("MDBOOK_PREPROCESSOR__CUTOFF__COMMAND", preprocessor);
    Ok(mdbook)
}

fn succeeds(mdbook: &mut Command) -> Result<bool> {
    match mdbook.status() {
        Ok(status) => Ok(status.success()),
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            bail!("mdbook is not installed: scripts/setup.sh installs it")
        }
        Err(e) => Err(e).context("mdbook did not start"),
    }
}

/// A search must not show the answer that a fold hides: the index of the built book becomes that
/// of a book without hints.
fn index_without_hints(kit: &Kit) -> Result<()> {
    let folder = tempfile::tempdir()?;
    let mut without = mdbook(kit, "build")?;
    without.arg("--dest-dir").arg(folder.path()).env(WITHOUT_HINTS, "");
    without.stdout(Stdio::null()).stderr(Stdio::null());
    if !succeeds(&mut without)? {
        bail!("the book without hints cannot be built");
    }
    let index = |folder: &Path| -> Result<PathBuf> {
        let mut files = fs::read_dir(folder)?.filter_map(|entry| Some(entry.ok()?.path()));
        let is_index = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("searchindex") && name.ends_with(".js")
        };
        files.find(is_index).with_context(|| format!("{} has no search index", folder.display()))
    };
    // The name holds a hash of the content, which is only there to be new when that is.
    fs::copy(index(folder.path())?, index(&kit.path("book/build"))?)?;
    Ok(())
}

fn check(kit: &Kit) -> Result<bool> {
    let faults = [
        snippets::check(kit)?,
        sections::check(kit)?,
        reports::check(kit)?,
        compare::check(kit)?,
        parts::check(kit)?,
        locations::check(kit)?,
        tables::check(kit)?,
        glossary::check(kit)?,
    ]
    .concat();
    for fault in &faults {
        eprintln!("{fault}");
    }
    Ok(links_lead_somewhere(&kit.path("book/build"))? && faults.is_empty())
}

/// Asks lychee, where it is installed, whether all links inside the built book lead to something.
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

/// Serves mdBook as a preprocessor: reads a book from the standard input, fills and renders what
/// only the kit knows, and writes the book to the standard output.
pub(crate) fn preprocess(kit: &Kit) -> Result<ExitCode> {
    let (context, mut book) = parse_input(io::stdin())?;
    let edit: Option<String> = context.config.get("output.html.edit-url-template")?;
    let edit = edit.unwrap_or_default();
    let with_hints = env::var_os(WITHOUT_HINTS).is_none();
    let mut result = Ok(());
    book.for_each_mut(|item| {
        if let (BookItem::Chapter(chapter), Ok(())) = (item, &result) {
            match page(kit, chapter, &edit, with_hints) {
                Ok(text) => chapter.content = text,
                Err(e) => result = Err(e.context(format!("chapter '{}'", chapter.name))),
            }
        }
    });
    result?;
    serde_json::to_writer(BufWriter::new(io::stdout()), &book)?;
    Ok(ExitCode::SUCCESS)
}

fn page(kit: &Kit, chapter: &Chapter, edit: &str, with_hints: bool) -> Result<String> {
    let file = chapter.path.as_deref().unwrap_or(Path::new(""));
    let mut text = markers::fill(kit, &chapter.content)?;
    if with_hints {
        text = hints::beside_tasks(kit, file, &text)?;
    }
    let folder = kit.path("book/src").join(file.parent().unwrap_or(Path::new("")));
    let text = figures::link(&math::render(&text)?, &folder);
    let text = ending::scripts(text, file.components().count().saturating_sub(1));
    // The foot is on every page: a search must not find it.
    Ok(if with_hints { text + &ending::foot(file, edit) } else { text })
}
