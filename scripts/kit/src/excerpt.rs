//! Excerpts of the kit's sources for the book. They never show an answer.

use std::ops::RangeInclusive;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::answers::{self, Part};
use crate::files::read_text;

/// A range of lines, counted from 1.
type Lines = RangeInclusive<usize>;

/// Returns the lines that mdBook would show; `None` if the part does not exist.
fn shown(lines: &[&str], part: &str) -> Option<Lines> {
    let mut numbers = part.split(':');
    match (numbers.next().unwrap_or_default(), numbers.next()) {
        ("", None) => Some(1..=lines.len()),
        (first, last) if first.is_empty() || first.parse::<usize>().is_ok() => {
            let first = first.parse().unwrap_or(1);
            Some(first..=last.map_or(first, |last| last.parse().unwrap_or(lines.len())))
        }
        (anchor, _) => {
            let find = |key: &str| lines.iter().position(|l| is_anchor(l, key, anchor));
            Some(find("ANCHOR:")? + 1..=find("ANCHOR_END:")? + 1)
        }
    }
}

/// Returns the text that an include of `part` of a file shows, without anchors.
///
/// # Errors
/// If the file cannot be read, has no such part, or if the part contains an answer.
pub fn excerpt(file: &Path, part: &str) -> Result<String> {
    let source = read_text(file)?;
    let lines: Vec<&str> = source.lines().collect();
    let range = shown(&lines, part).with_context(|| format!("there is no anchor '{part}'"))?;
    if file.extension().is_some_and(|e| e == "rs") {
        let overlap = |a: &Lines| a.start() <= range.end() && range.start() <= a.end();
        if let Some(answer) = answers(file, &source)?.into_iter().find(overlap) {
            bail!("it shows the answer in lines {} to {}", answer.start(), answer.end());
        }
    }
    let shown = lines.iter().zip(1..).filter(|(_, number)| range.contains(number));
    let kept = shown.map(|(line, _)| *line).filter(|line| !line.contains("ANCHOR"));
    Ok(kept.flat_map(|line| [line, "\n"]).collect())
}

fn is_anchor(line: &str, key: &str, anchor: &str) -> bool {
    let Some((before, after)) = line.split_once(key) else { return false };
    !before.ends_with('_') && after.split_whitespace().next() == Some(anchor)
}

/// Returns the lines, including marks, of answers and of items that only answers need.
fn answers(file: &Path, source: &str) -> Result<Vec<Lines>> {
    let mut answers = Vec::new();
    let mut line = 1;
    for part in answers::parse(file, source)? {
        let given = matches!(part, Part::Given(_));
        let marks = if given { 0 } else { 2 };
        let next = line + part.text().lines().count() + marks;
        if !given {
            answers.push(line..=next - 1);
        }
        line = next;
    }
    Ok(answers)
}
