//! mdBook's preprocessor: changes each page before mdBook renders it.
//!
//! The preprocessor replaces markers, inserts hints, folds questions, renders formulas as MathML,
//! and makes each drawing a link. It also adds the scripts of the figures, and a foot.

use std::env;
use std::io::{self, BufWriter};
use std::path::Path;
use std::process::ExitCode;

use anyhow::Result;
use mdbook_preprocessor::book::{BookItem, Chapter};
use mdbook_preprocessor::parse_input;

use lab_kit::Kit;

use crate::ending::Page;
use crate::entries::Data;
use crate::{
    alignment, chapter_tasks, drawings, ending, markers, math, predictions, understanding,
};

/// Environment variable that makes the preprocessor omit the hints.
pub(crate) const WITHOUT_HINTS: &str = "CUTOFF_BOOK_WITHOUT_HINTS";

/// Reads a book from standard input and writes it to standard output.
pub(crate) fn run(kit: &Kit) -> Result<ExitCode> {
    let (context, mut book) = parse_input(io::stdin())?;
    let edit: Option<String> = context.config.get("output.html.edit-url-template")?;
    let edit = edit.unwrap_or_default();
    let with_hints = env::var_os(WITHOUT_HINTS).is_none();
    let pages: Vec<Page> = book.iter().filter_map(listed).collect();
    let mut data = Data::new(kit);
    let mut result = Ok(());
    book.for_each_mut(|item| {
        if let (BookItem::Chapter(chapter), Ok(())) = (item, &result) {
            match page(&mut data, chapter, with_hints) {
                Ok(text) if with_hints => chapter.content = text + &end(chapter, &pages, &edit),
                // All pages have the same foot, so the search index must not contain it.
                Ok(text) => chapter.content = text,
                Err(e) => result = Err(e.context(format!("chapter '{}'", chapter.name))),
            }
        }
    });
    result?;
    serde_json::to_writer(BufWriter::new(io::stdout()), &book)?;
    Ok(ExitCode::SUCCESS)
}

/// Returns a page's name and file; `None` for a part of the book and for a draft.
fn listed(item: &BookItem) -> Option<Page> {
    let BookItem::Chapter(chapter) = item else { return None };
    Some(Page { name: chapter.name.clone(), file: chapter.path.clone()? })
}

/// Returns the end of a page: links to its neighbours, and the foot.
fn end(chapter: &Chapter, pages: &[Page], edit: &str) -> String {
    let file = chapter.path.as_deref().unwrap_or(Path::new(""));
    ending::neighbours(pages, file) + &ending::foot(file, edit)
}

fn page(data: &mut Data, chapter: &Chapter, with_hints: bool) -> Result<String> {
    let file = chapter.path.as_deref().unwrap_or(Path::new(""));
    let mut text = markers::fill(data, &chapter.content)?;
    text = chapter_tasks::placed(data.kit, file, &text, with_hints)?;
    text = understanding::folded(file, &predictions::unfolded(&text)?, with_hints)?;
    text = alignment::aligned(&text);
    let folder = data.kit.path("book/src").join(file.parent().unwrap_or(Path::new("")));
    let text = drawings::link(&math::render(&text)?, &folder);
    Ok(ending::scripts(text, file.components().count().saturating_sub(1)))
}
