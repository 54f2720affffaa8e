//! The book of a handout: the chapters of its labs, and nothing that leads elsewhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::copy::{add, add_all};
use lab_kit::excerpt::excerpt;
use lab_kit::files::read_text;
use lab_kit::starter::Files;
use lab_kit::{Kit, Lab, files_below};

/// Pages about all labs at once, which measure and compare what a handout does not have.
const ABOUT_ALL: [&str; 2] = ["compare.md", "reports.md"];

/// The part of the table of contents that is not for students.
const INSTRUCTORS: &str = "For instructors";

/// Adds the book for `labs`.
pub(super) fn add_pages(kit: &Kit, labs: &[Lab], files: &mut Files) -> Result<()> {
    if !kit.path("book/book.toml").is_file() {
        return Ok(());
    }
    // What is set for instructors' pages goes with them.
    let settings = read_text(&kit.path("book/book.toml"))?;
    let settings = settings.split_inclusive('\n').filter(|line| !line.starts_with("\"instructor/"));
    files.insert("book/book.toml".into(), settings.collect::<String>().into_bytes());
    for folder in ["book/theme", "book/src/fonts", "book/src/live"] {
        add_all(kit, files, &kit.path(folder))?;
    }
    let (mut kept, mut left_out) = (Vec::new(), BTreeSet::new());
    let src = kit.path("book/src");
    for path in files_below(&src)? {
        let name = path.strip_prefix(&src)?.to_string_lossy().into_owned();
        if !name.ends_with(".md") || name == "SUMMARY.md" {
            continue;
        }
        if is_for(&name, labs) {
            kept.push((name, path));
        } else {
            left_out.insert(name);
        }
    }
    let mut all = String::new();
    for (name, path) in kept {
        let text = with_code(kit, &path, &read_text(&path)?, files)?;
        let text = unlinked(&text, &left_out);
        all.push_str(&text);
        files.insert(Path::new("book/src").join(name), text.into_bytes());
    }
    for path in files_below(&src.join("figures"))? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if all.contains(&*name) {
            add(kit, files, &path)?;
        }
    }
    let summary = contents(&read_text(&src.join("SUMMARY.md"))?, &left_out);
    files.insert("book/src/SUMMARY.md".into(), summary.into_bytes());
    Ok(())
}

/// Whether a page is for students of these labs.
fn is_for(page: &str, labs: &[Lab]) -> bool {
    let number = page.strip_prefix("lab").and_then(|rest| rest.strip_suffix(".md"));
    let number = number.map(|number| number.strip_suffix("-more").unwrap_or(number));
    match number.and_then(|number| number.parse::<Lab>().ok()) {
        Some(lab) => labs.contains(&lab),
        None => !page.starts_with("instructor/") && !ABOUT_ALL.contains(&page),
    }
}

/// The table of contents: what is left out stands there in grey; pages about all labs and instructors' do not,
/// nor does a heading whose pages are all gone.
fn contents(summary: &str, left_out: &BTreeSet<String>) -> String {
    let line = |line: &str| {
        let target = line.rsplit_once("](").and_then(|(_, rest)| rest.strip_suffix(')'));
        match target.filter(|target| left_out.contains(*target)) {
            Some(target) if ABOUT_ALL.contains(&target) => None,
            Some(target) => Some(line.replace(&format!("({target})"), "()")),
            None => Some(line.to_owned()),
        }
    };
    let part = |(at, part): (usize, &str)| {
        let lines: Vec<String> = part.lines().filter_map(line).collect();
        let empty = lines.iter().skip(1).all(String::is_empty);
        let gone = at > 0 && (empty || lines[0] == INSTRUCTORS);
        (!gone).then(|| lines.join("\n").trim_end().to_owned())
    };
    let parts: Vec<_> = summary.split("\n# ").enumerate().filter_map(part).collect();
    parts.join("\n\n# ") + "\n"
}

/// The text with code from files that the handout lacks put in.
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
        // A lab's starter has no anchors, so what is shown of it is written out.
        if files.contains_key(&in_kit) && !in_kit.starts_with("labs") {
            out.push_str(line);
            continue;
        }
        let shown = excerpt(&source, part);
        out.push_str(&shown.with_context(|| format!("{}: {include}", page.display()))?);
    }
    Ok(out)
}

/// The text with links to pages that are left out turned into their words.
fn unlinked(text: &str, left_out: &BTreeSet<String>) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(middle) = rest.find("](") {
        let after = &rest[middle + 2..];
        let end = after.find(')').unwrap_or(0);
        let target = after[..end].split('#').next().unwrap_or_default();
        let begin = rest[..middle].rfind('[');
        match begin {
            Some(begin) if left_out.contains(target.trim_start_matches("./")) => {
                out.push_str(&rest[..begin]);
                out.push_str(&rest[begin + 1..middle]);
                rest = &after[end + 1..];
            }
            _ => {
                out.push_str(&rest[..middle + 2]);
                rest = after;
            }
        }
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::{contents, is_for, unlinked};

    #[test]
    fn pages_of_later_labs_and_of_instructors_are_left_out() {
        let labs = ["1".parse().unwrap(), "2".parse().unwrap()];
        for (page, kept) in [
            ("lab2.md", true),
            ("lab10.md", false),
            ("lab2-more.md", true),
            ("lab10-more.md", false),
            ("models.md", true),
            ("compare.md", false),
            ("instructor/grading.md", false),
        ] {
            assert_eq!(is_for(page, &labs), kept, "{page}");
        }
    }

    #[test]
    fn the_contents_fit() {
        let summary = "# Summary\n\n# One\n\n- [Lab 1](lab1.md)\n- [Lab 2](lab2.md)\n\n\
                       # Side by side\n\n- [All](compare.md)\n\n\
                       # For instructors\n\n- [Grading](instructor/grading.md)\n";
        let left_out = ["lab2.md", "compare.md", "instructor/grading.md"].map(String::from).into();
        assert_eq!(
            contents(summary, &left_out),
            "# Summary\n\n# One\n\n- [Lab 1](lab1.md)\n- [Lab 2]()\n"
        );
    }

    #[test]
    fn a_link_to_nowhere_becomes_its_words() {
        let left_out = ["lab6.md".to_owned()].into();
        assert_eq!(
            unlinked("as [lab 6](lab6.md#halo) and [lab 5](lab5.md) say", &left_out),
            "as lab 6 and [lab 5](lab5.md) say"
        );
    }
}
