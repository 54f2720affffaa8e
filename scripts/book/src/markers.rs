//! What a chapter may ask for: `{{#opening 2}}`, `{{#reports}}`, `{{#compare soft}}` and, for instructors, `{{#labs}}`,
//! `{{#mistakes 2}}` and `{{#rubric}}`.

use anyhow::Result;

use crate::{compare, instructor, opening, reports, rubric};
use lab_kit::Kit;

/// Replaces the markers of a chapter by what they ask for.
///
/// - `{{#opening 2}}`: what begins lab 2's chapter, from `book/chapters.toml`.
/// - `{{#reports}}`: the table of all tables and figures of the course reports.
/// - `{{#reports cs267}}`: those of one report.
/// - `{{#compare soft}}`: every variant of soft discs side by side; `{{#compare hard}}`: of hard ones.
/// - `{{#labs}}`: how long each lab takes and what it needs.
/// - `{{#mistakes 2}}`: the known-wrong answers to lab 2, from `tests/wrong`.
/// - `{{#rubric}}`: what every task and measure is worth, from `tests/rubric.toml`.
///
/// # Errors
/// The marker asks for something that is not there.
pub(crate) fn fill(kit: &Kit, markdown: &str) -> Result<String> {
    let mut out = String::with_capacity(markdown.len());
    let mut rest = markdown;
    while let Some(start) = rest.find("{{#") {
        let Some(length) = rest[start..].find("}}") else { break };
        let marker = &rest[start + 3..start + length];
        out.push_str(&rest[..start]);
        let (name, argument) = marker.split_once(' ').unwrap_or((marker, ""));
        match name {
            "opening" => out.push_str(&opening::opening(kit, argument.trim())?),
            "labs" => out.push_str(&instructor::labs(kit)?),
            "mistakes" => out.push_str(&instructor::mistakes(kit, argument.trim())?),
            "rubric" => out.push_str(&rubric::tables(kit)?),
            "compare" => out.push_str(&compare::table(kit, argument.trim())?),
            "reports" => out.push_str(&reports::table(kit, argument.trim())?),
            // mdBook's own markers are gone by now, except an escaped one.
            _ => out.push_str(&rest[start..start + length + 2]),
        }
        rest = &rest[start + length + 2..];
    }
    out.push_str(rest);
    Ok(out)
}
