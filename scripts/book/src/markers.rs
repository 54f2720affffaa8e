//! What a chapter may ask for: `{{#opening 2}}`, `{{#reports}}`, `{{#compare soft}}`, `{{#labs ranks}}` and, for
//! instructors, `{{#labs}}`, `{{#mistakes}}` and `{{#rubric}}`.

use anyhow::Result;

use crate::{compare, labs, reports};
use lab_kit::Kit;

/// Replaces the markers of a chapter by what they ask for.
///
/// - `{{#opening 2}}`: what begins lab 2's chapter, from its facts.
/// - `{{#reports}}`: the table of all tables and figures of the course reports.
/// - `{{#compare soft}}`: every variant of soft discs side by side; `{{#compare hard}}`: of hard ones.
/// - `{{#labs}}`: how long each lab takes and what it needs; `{{#labs ranks}}`: the numbers of those with ranks.
/// - `{{#mistakes}}`: the known-wrong answers to each lab, from `tests/wrong`.
/// - `{{#rubric}}`: what every task and measure is worth, from the facts of the labs.
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
            "opening" => out.push_str(&labs::opening(kit, argument.trim())?),
            "labs" if argument.is_empty() => out.push_str(&labs::labs(kit)?),
            "labs" => out.push_str(&labs::labs_with(kit, argument.trim())?),
            "mistakes" => out.push_str(&labs::mistakes(kit)?),
            "rubric" => out.push_str(&labs::rubric(kit)?),
            "compare" => out.push_str(&compare::table(kit, argument.trim())?),
            "reports" => out.push_str(&reports::table(kit)?),
            // mdBook's own markers are gone by now, except an escaped one.
            _ => out.push_str(&rest[start..start + length + 2]),
        }
        rest = &rest[start + length + 2..];
    }
    out.push_str(rest);
    Ok(out)
}
