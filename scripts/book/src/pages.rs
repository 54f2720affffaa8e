//! The book's pages, their tables and their sections, for the checks.

use std::collections::BTreeMap;

use anyhow::Result;

use lab_kit::Kit;
use lab_kit::files::{files_below, read_text};

/// Returns the text of every page by its path in the kit, such as
/// `book/src/instructor/mistakes.md`.
pub(crate) fn pages(kit: &Kit) -> Result<BTreeMap<String, String>> {
    let mut pages = BTreeMap::new();
    for path in files_below(&kit.path("book/src"))? {
        if path.extension().is_some_and(|extension| extension == "md") {
            let name = path.strip_prefix(kit.root()).unwrap_or(&path).display().to_string();
            pages.insert(name, read_text(&path)?);
        }
    }
    Ok(pages)
}

/// A table of a page.
pub(crate) struct Table<'t> {
    /// Line number of the table's first row.
    pub(crate) line: usize,
    /// Cells of each row: the titles, the line of dashes, and the data.
    pub(crate) rows: Vec<Vec<&'t str>>,
    /// The comment above the table, or `None`.
    pub(crate) comment: Option<&'t str>,
    /// The second-level heading above the table.
    pub(crate) heading: &'t str,
}

/// Returns the tables of a page.
pub(crate) fn tables(text: &str) -> Vec<Table<'_>> {
    let mut tables = Vec::<Table>::new();
    let mut comment = None;
    let mut heading = "";
    let mut code = false;
    let mut inside = false;
    for (line, number) in text.lines().zip(1..) {
        code ^= line.trim_start().starts_with("```");
        if code {
            continue;
        }
        if line.starts_with("## ") {
            heading = line.trim_end();
        }
        let row = line.trim().strip_prefix('|').and_then(|row| row.strip_suffix('|'));
        let Some(row) = row else {
            inside = false;
            if !line.is_empty() {
                comment = line.strip_prefix("<!-- ").and_then(|text| text.strip_suffix(" -->"));
            }
            continue;
        };
        if !inside {
            inside = true;
            let comment = comment.take();
            tables.push(Table { line: number, rows: Vec::new(), comment, heading });
        }
        let cells = row.split('|').map(str::trim).collect();
        tables.last_mut().expect("one was just pushed").rows.push(cells);
    }
    tables
}

/// Returns the section that has this anchor, including its heading. Returns the whole page if the
/// anchor is empty.
pub(crate) fn section(text: &str, anchor: &str) -> Option<String> {
    if anchor.is_empty() {
        return Some(text.to_owned());
    }
    let mut out = String::new();
    let mut inside = 0;
    let mut code = false;
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

/// Returns the anchor that mdBook makes from a heading.
fn slug(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}
