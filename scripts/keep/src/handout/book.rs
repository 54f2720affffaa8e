//! The book of a handout: the chapters of its labs. Each other page only says that it is missing.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::Earlier;
use super::copied::{add, add_all};
use lab_kit::excerpt::excerpt;
use lab_kit::files::read_text;
use lab_kit::starter::Files;
use lab_kit::{Kit, Lab, files_below, quiz};

/// Pages about all labs, which contain measurements of labs that a handout does not have.
const ABOUT_ALL: [&str; 2] = ["compare.md", "reports.md"];

/// The title of the part for instructors, the last part of the table of contents.
const INSTRUCTORS: &str = "# For instructors";

/// The text of a page that the handout lacks, below its title.
const NOT_HERE: &str = "This page is about labs that your kit does not have yet.";

/// Adds the book for `labs`.
pub(super) fn add_pages(
    kit: &Kit,
    labs: &[Lab],
    earlier: Earlier,
    files: &mut Files,
) -> Result<()> {
    if !kit.path("book/book.toml").is_file() {
        return Ok(());
    }
    // The settings for instructors' pages are removed with the pages.
    let settings = read_text(&kit.path("book/book.toml"))?;
    let settings = settings.split_inclusive('\n').filter(|line| !line.starts_with("\"instructor/"));
    files.insert("book/book.toml".into(), settings.collect::<String>().into_bytes());
    for folder in ["book/theme", "book/src/fonts", "book/src/live"] {
        add_all(kit, files, &kit.path(folder))?;
    }
    let last = labs.len().saturating_sub(1);
    let collected = if earlier == Earlier::Own { &[] } else { &labs[..last] };
    let src = kit.path("book/src");
    let mut all = String::new();
    for path in files_below(&src)? {
        let name = path.strip_prefix(&src)?.to_string_lossy().into_owned();
        if !name.ends_with(".md") || name.starts_with("instructor/") {
            continue;
        }
        let text = read_text(&path)?;
        let text = match &*name {
            "SUMMARY.md" => text.split(INSTRUCTORS).next().unwrap_or_default().to_owned(),
            _ if is_for(&name, labs) => {
                with_code(kit, &path, &with_quizzes(kit, collected, &text)?, files)?
            }
            _ => format!("{}\n\n{NOT_HERE}\n", text.lines().next().unwrap_or_default()),
        };
        all.push_str(&text);
        files.insert(Path::new("book/src").join(name), text.into_bytes());
    }
    // Only the pictures and data files that the handout's pages name are added.
    for folder in ["book/src/figures", "book/data"] {
        for path in files_below(&kit.path(folder))? {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if all.contains(&*name) {
                add(kit, files, &path)?;
            }
        }
    }
    Ok(())
}

/// Whether a page is for students of these labs.
fn is_for(page: &str, labs: &[Lab]) -> bool {
    let number = page.strip_prefix("lab").and_then(|rest| rest.strip_suffix(".md"));
    let number = number.map(|number| number.strip_suffix("-more").unwrap_or(number));
    match number.and_then(|number| number.parse::<Lab>().ok()) {
        Some(lab) => labs.contains(&lab),
        None => !ABOUT_ALL.contains(&page),
    }
}

/// Returns the text with the quizzes about `collected` labs written out as Markdown.
///
/// A quiz shows the code of a known-wrong program, and the handout has no such programs. A quiz
/// reveals much of an answer, so the quizzes about labs that are not collected yet are removed.
fn with_quizzes(kit: &Kit, collected: &[Lab], text: &str) -> Result<String> {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let marker = line.trim().strip_prefix("{{#quiz ").and_then(|l| l.strip_suffix("}}"));
        let Some(words) = marker else {
            out.push_str(line);
            continue;
        };
        let (lab, program) = quiz::marked(words)?;
        if collected.contains(&lab) {
            out += &quiz::markdown(kit, lab, program)?.unwrap_or_default();
        }
    }
    Ok(out)
}

/// Returns the text with code in place of each include of a file that the handout lacks.
///
/// Includes of files in `labs` are replaced by code, too.
fn with_code(kit: &Kit, page: &Path, text: &str, files: &Files) -> Result<String> {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let include = line.trim().strip_prefix("{{#include ").and_then(|l| l.strip_suffix("}}"));
        let Some(include) = include.map(str::trim) else {
            out.push_str(line);
            continue;
        };
        let (path, part) = include.split_once(':').unwrap_or((include, ""));
        let source = page.parent().unwrap_or(page).join(path);
        let source = fs::canonicalize(&source)
            .with_context(|| format!("{} shows {path}", page.display()))?;
        let in_kit = source.strip_prefix(fs::canonicalize(kit.root())?)?.to_owned();
        // A lab's starter has no anchors, so an include of a part of it would find nothing.
        if files.contains_key(&in_kit) && !in_kit.starts_with("labs") {
            out.push_str(line);
            continue;
        }
        let shown = excerpt(&source, part);
        out.push_str(&shown.with_context(|| format!("{}: {include}", page.display()))?);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::is_for;

    #[test]
    fn pages_of_later_labs_are_not_for_now() {
        let labs = ["1".parse().unwrap(), "2".parse().unwrap()];
        for (page, kept) in [
            ("lab2.md", true),
            ("lab10.md", false),
            ("lab2-more.md", true),
            ("lab10-more.md", false),
            ("models.md", true),
            ("compare.md", false),
        ] {
            assert_eq!(is_for(page, &labs), kept, "{page}");
        }
    }
}
