//! Excerpts of the kit's sources for the book. They never show an answer.

use std::ops::RangeInclusive;
use std::path::Path;

use anyhow::{Context, Result, ensure};

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
        (anchor, _) => Some(find(lines, "ANCHOR:", anchor)?..=find(lines, "ANCHOR_END:", anchor)?),
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
        for answer in answers(file, &source)? {
            let overlaps = answer.start() <= range.end() && range.start() <= answer.end();
            let (first, last) = answer.into_inner();
            ensure!(!overlaps, "it shows the answer in lines {first} to {last}");
        }
    }
    let shown = lines.iter().zip(1..).filter(|(_, number)| range.contains(number));
    let kept = shown.map(|(line, _)| *line).filter(|line| !line.contains("ANCHOR"));
    Ok(kept.flat_map(|line| [line, "\n"]).collect())
}

/// Finds the line, from 1, of an anchor's beginning (`ANCHOR:`) or end (`ANCHOR_END:`).
fn find(lines: &[&str], key: &str, anchor: &str) -> Option<usize> {
    let at = lines.iter().position(|line| {
        line.split_once(key).is_some_and(|(before, after)| {
            !before.ends_with('_') && after.split_whitespace().next() == Some(anchor)
        })
    });
    at.map(|at| at + 1)
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
