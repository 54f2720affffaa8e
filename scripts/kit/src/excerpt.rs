//! Excerpts of the kit's own sources, as the book shows them; they never show an answer.

use std::ops::RangeInclusive;
use std::path::Path;

use anyhow::{Context, Result};

use crate::answers::{self, MarkError, Part};
use crate::files::read_text;

/// The lines, counted from 1, that mdBook would show.
pub fn shown(lines: &[&str], part: &str) -> Option<RangeInclusive<usize>> {
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

/// The text that an include of `part` of a file shows, without anchors; none if it would show an
/// answer.
///
/// # Errors
/// The file cannot be read, or has no such part.
pub fn excerpt(file: &Path, part: &str) -> Result<Option<String>> {
    let source = read_text(file)?;
    let lines: Vec<&str> = source.lines().collect();
    let range = shown(&lines, part).with_context(|| format!("there is no anchor '{part}'"))?;
    let is_rust = file.extension().is_some_and(|e| e == "rs");
    if is_rust && answer_within(file, &source, &range)?.is_some() {
        return Ok(None);
    }
    let last = (*range.end()).min(lines.len());
    let kept = lines[range.start() - 1..last].iter().filter(|line| !line.contains("ANCHOR"));
    Ok(Some(kept.flat_map(|line| [*line, "\n"]).collect()))
}

fn is_anchor(line: &str, key: &str, anchor: &str) -> bool {
    let Some((before, after)) = line.split_once(key) else { return false };
    !before.ends_with('_') && after.split_whitespace().next() == Some(anchor)
}

/// The first answer that these lines show something of.
pub fn answer_within(
    file: &Path,
    source: &str,
    shown: &RangeInclusive<usize>,
) -> Result<Option<RangeInclusive<usize>>, MarkError> {
    let mut answers = answers(file, source)?.into_iter();
    Ok(answers.find(|a| a.start() <= shown.end() && shown.start() <= a.end()))
}

/// The lines, marks included, of answers and of what only answers need.
fn answers(file: &Path, source: &str) -> Result<Vec<RangeInclusive<usize>>, MarkError> {
    let mut answers = Vec::new();
    let mut line = 1;
    for part in answers::parse(file, source)?.parts {
        let (text, marks) = match &part {
            Part::Given(text) => (text, 0),
            Part::Answer(region) => (&region.body, 2),
            Part::AnswerOnly(text) => (text, 2),
        };
        let next = line + text.lines().count() + marks;
        if marks > 0 {
            answers.push(line..=next - 1);
        }
        line = next;
    }
    Ok(answers)
}
