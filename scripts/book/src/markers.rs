//! Markers in chapters, such as `{{#opening 2}}`, which are replaced by generated text.
//!
//! The list of markers is at [`fill`].

use anyhow::Result;

use crate::entries::Data;
use crate::{labs, printed, reports, variants};
use lab_kit::{Kit, quiz};

/// Replaces the markers of a chapter by generated text.
///
/// - `{{#opening 2}}`: the opening of lab 2's chapter, from the lab's facts.
/// - `{{#table lab2-race.json}}`: fills the [table](printed) that follows with numbers from this
///   data file.
/// - `{{#quiz 2 corner_forgotten}}`: the [quiz](lab_kit::quiz) about a known-wrong program of lab 2;
///   empty in a class's kit, which has no known-wrong programs.
/// - `{{#reports}}`: the table of all tables and figures of the course reports.
/// - `{{#compare soft}}`, `{{#compare hard}}`: tables of all variants of soft or hard discs.
/// - `{{#labs}}`: the time and the needs of each lab; `{{#labs ranks}}`: the numbers of the labs
///   with ranks.
/// - `{{#rubric}}`: the points of every task and measurement, from the facts of the labs.
///
/// # Errors
/// A marker names something that does not exist.
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
            // mdBook has replaced its own markers by now, except escaped ones.
            _ => out.push_str(&format!("{{{{#{marker}}}}}")),
        }
    }
    out.push_str(rest);
    Ok(out)
}

/// Returns the quiz about the lab and the program in `argument`.
///
/// The quiz is empty if the kit has no known-wrong programs.
fn quiz(kit: &Kit, argument: &str) -> Result<String> {
    let (lab, program) = quiz::marked(argument)?;
    Ok(quiz::markdown(kit, lab, program)?.unwrap_or_default())
}
