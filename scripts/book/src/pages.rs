//! The book's pages, as the checks read them.

use std::collections::BTreeMap;

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::files::{files_below, read_text};

/// The text of every page by its name in the kit, such as `book/src/instructor/mistakes.md`.
pub(crate) fn pages(kit: &Kit) -> Result<BTreeMap<String, String>> {
    let files = files_below(&kit.path("book/src"))?.into_iter();
    let pages = files.filter(|path| path.extension().is_some_and(|e| e == "md"));
    let named = |path: std::path::PathBuf| {
        let name = path.strip_prefix(kit.root()).unwrap_or(&path).display().to_string();
        Ok((name, read_text(&path)?))
    };
    pages.map(named).collect()
}

/// The section of a page that a link's anchor names, heading and all, or the whole page where it names none.
pub(crate) fn section(text: &str, anchor: &str) -> Option<String> {
    if anchor.is_empty() {
        return Some(text.to_owned());
    }
    let (mut out, mut inside, mut code) = (String::new(), 0, false);
    for line in text.lines() {
        code ^= line.starts_with("```");
        let level = line.find(|c| c != '#').unwrap_or(line.len());
        if level > 0 && !code {
            if inside == 0 && slug(&line[level..]) == anchor {
                inside = level;
            } else if inside > 0 && level <= inside {
                break;
            }
        }
        if inside > 0 {
            out += &format!("{line}\n");
        }
    }
    (inside > 0).then_some(out)
}

/// What mdBook makes of a heading.
fn slug(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}
