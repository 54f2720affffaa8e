//! A chapter's opening, made from the lab's facts: what the reader can do afterwards, what to know before, hours and
//! difficulty of each task.

use anyhow::Result;

use lab_kit::facts::TaskFacts;
use lab_kit::{Facts, Kit, Lab, hints};

/// How long a lab takes and what it needs, in one line.
pub(crate) fn needs(facts: &Facts) -> String {
    let hours = facts.reading + facts.tasks.values().map(|task| task.hours).sum::<f64>();
    format!("About {hours:.0} hours. You need {}.", facts.workers.need())
}

/// The opening of a lab's chapter.
pub(crate) fn opening(kit: &Kit, lab: &str) -> Result<String> {
    let lab: Lab = lab.parse().map_err(anyhow::Error::msg)?;
    let facts = kit.facts(lab)?;
    let mut out = format!("*{}*\n\n**Afterwards you can**\n\n", needs(&facts));
    for what in &facts.able {
        out += &format!("- {what}\n");
    }
    out += "\n**Before you begin** you should know\n\n";
    for what in &facts.before {
        out += &format!("- {what}\n");
    }
    out += "\n<details><summary>Hours and difficulty, task by task</summary>\n\n\
            | task | | hours | difficulty |\n|---|---|---:|---|\n";
    for hint in hints::read(kit, lab)? {
        let Some(TaskFacts { hours, mark, .. }) = facts.tasks.get(&hint.task.to_string()) else {
            continue;
        };
        let mark = "●".repeat(*mark) + &"○".repeat(3_usize.saturating_sub(*mark));
        out += &format!("| {} | {} | {hours} | {mark} |\n", hint.task, hint.title);
    }
    out += &format!("| | to read, predict, measure and explain | {} | |\n", facts.reading);
    Ok(out + "\n</details>\n")
}
