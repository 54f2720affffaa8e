//! What a chapter may ask for: `{{#opening 2}}`, `{{#table lab2-race.json}}`, `{{#reports}}`, `{{#compare soft}}`,
//! `{{#labs ranks}}` and, for instructors, `{{#labs}}` and `{{#rubric}}`.

use anyhow::{Context, Result, anyhow};

use crate::entries::Data;
use crate::{labs, printed, reports, variants};
use lab_kit::quiz;
use lab_kit::{Kit, Lab};

/// Replaces the markers of a chapter by what they ask for.
///
/// - `{{#opening 2}}`: what begins lab 2's chapter, from its facts.
/// - `{{#table lab2-race.json}}`: the numbers of the [table](printed) that follows, from its data file.
/// - `{{#quiz 2 corner_forgotten}}`: the [quiz](lab_kit::quiz) about a known-wrong program of lab 2; nothing in
///   a class's kit, which has no known-wrong programs.
/// - `{{#reports}}`: the table of all tables and figures of the course reports.
/// - `{{#compare soft}}`: every variant of soft discs side by side; `{{#compare hard}}`: of hard ones.
/// - `{{#labs}}`: how long each lab takes and what it needs; `{{#labs ranks}}`: the numbers of those with ranks.
/// - `{{#rubric}}`: what every task and measure is worth, from the facts of the labs.
///
/// # Errors
/// The marker asks for something that is not there.
pub(crate) fn fill(data: &mut Data, markdown: &str) -> Result<String> {
    let kit = data.kit;
    let mut out = String::with_capacity(markdown.len());
    let mut rest = markdown;
    while let Some(start) = rest.find("{{#") {
        let Some(length) = rest[start..].find("}}") else { break };
        let marker = &rest[start + 3..start + length];
        out.push_str(&rest[..start]);
        let after = &rest[start + length + 2..];
        let (name, argument) = marker.split_once(' ').unwrap_or((marker, ""));
        rest = after;
        match name {
            "table" => {
                let (table, after) = printed::table(data, argument, after)?;
                out.push_str(&table);
                rest = after;
            }
            "opening" => out.push_str(&labs::opening(kit, argument.trim())?),
            "labs" if argument.is_empty() => out.push_str(&labs::labs(kit)?),
            "labs" => out.push_str(&labs::labs_with(kit, argument.trim())?),
            "rubric" => out.push_str(&labs::rubric(kit)?),
            "compare" => out.push_str(&variants::table(data, argument.trim())?),
            "quiz" => out.push_str(&quiz(kit, argument)?),
            "reports" => out.push_str(&reports::table(data)?),
            // mdBook's own markers are gone by now, except an escaped one.
            _ => out.push_str(&format!("{{{{#{marker}}}}}")),
        }
    }
    out.push_str(rest);
    Ok(out)
}

/// The quiz that `argument` names by its lab and its program; empty if the kit has no such programs.
fn quiz(kit: &Kit, argument: &str) -> Result<String> {
    let (lab, program) = argument.split_once(' ').context("a quiz has a lab and a program")?;
    let lab: Lab = lab.parse().map_err(|e| anyhow!("quiz: {e}"))?;
    Ok(quiz::markdown(kit, lab, program)?.unwrap_or_default())
}
