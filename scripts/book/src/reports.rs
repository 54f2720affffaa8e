//! Nothing of the course reports is lost: book/figures.toml lists every table, figure, claim and
//! wish of theirs, with the command that makes it again here and the page that shows both numbers.
//!
//! The kit's own number is not typed there: it is read from a data file ([`Here`]), with the command that made
//! the file, and must be of the same quantity as the report's.

mod here;
#[cfg(test)]
mod tests;

use anyhow::Result;
use serde::Deserialize;

use lab_kit::Kit;
use lab_kit::command::{Family, families};
use lab_kit::files::{read_text, read_toml};

use self::here::Here;
use crate::pages;
use crate::tables::numbers;

/// The reports, as figures.toml calls them, and as a reader knows them.
const REPORTS: [(&str, &str); 4] = [
    ("cs267", "CS267, Berkeley 2018"),
    ("csc581", "CSC581"),
    ("csc367", "CSC367, Toronto"),
    ("cs3210", "CS3210, Singapore"),
];

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    figure: Vec<Figure>,
}

/// A table or figure of a report, or something that it claims or leaves to future work.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Figure {
    report: String,
    /// Its number there, such as `Table 2`.
    number: String,
    what: String,
    /// What makes it again, where `here` does not say so; none for a drawing made by hand.
    command: Option<String>,
    /// The file in book/src that shows both; a `#section` may follow.
    page: Option<String>,
    /// A number of theirs.
    there: Option<There>,
    /// The kit's own beside it.
    here: Option<Here>,
    /// It has no numbers: the page shows how it is done here.
    #[serde(default)]
    numberless: bool,
    /// Why it is not made again.
    left_out: Option<String>,
}

/// A number of a report.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct There {
    /// As the page prints it.
    number: String,
    /// Its quantity and unit, such as `ms a step`.
    is: String,
}

fn read(kit: &Kit) -> Result<Vec<Figure>> {
    Ok(read_toml::<List>(&kit.path("book/figures.toml"))?.figure)
}

/// The table of what became of each table and figure of the reports.
///
/// # Errors
/// The list cannot be read.
pub(crate) fn table(kit: &Kit) -> Result<String> {
    let figures = read(kit)?;
    let mut out = String::new();
    for (name, title) in REPORTS {
        out.push_str(&format!("\n## {title}\n\n| there | what | here |\n|---|---|---|\n"));
        for figure in figures.iter().filter(|f| f.report == name) {
            out.push_str(&format!(
                "| {} | {} | {} |\n",
                figure.number,
                figure.what,
                figure.here(kit)?
            ));
        }
    }
    Ok(out)
}

impl Figure {
    fn here(&self, kit: &Kit) -> Result<String> {
        let page = match (&self.page, &self.left_out) {
            (_, Some(why)) => return Ok(format!("left out: {why}")),
            (None, None) => return Ok("missing".into()),
            (Some(page), None) => page,
        };
        if let Some((there, here)) = self.there.as_ref().zip(self.here.as_ref()) {
            let found = here.read(kit)?;
            let section = section(kit, page).unwrap_or_default();
            let (number, is) = (there.number.as_str(), found.is);
            let ours = printed(&section, found.value).unwrap_or("missing");
            return Ok(format!("[{number} – {ours}]({page}) {is}, `{}`", found.command));
        }
        let by = self.command.as_ref().map(|command| format!(", `{command}`"));
        Ok(format!("[page]({page}){}", by.unwrap_or_default()))
    }

    /// What is wrong with this entry.
    fn fault(&self, kit: &Kit) -> Option<String> {
        if !REPORTS.iter().any(|(name, _)| *name == self.report) {
            return Some("no such report".into());
        }
        let page = match (&self.page, &self.left_out) {
            (None, Some(_)) if self.command.is_none() => return None,
            (Some(page), None) => page,
            _ => return Some("it needs either a page or a reason why it is left out".into()),
        };
        let section = match section(kit, page) {
            Ok(section) => section,
            Err(why) => return Some(why),
        };
        match (&self.there, &self.here, &self.command) {
            (None, None, None) if self.numberless => None,
            (None, None, Some(command)) if self.numberless => not_understood(kit, command),
            (Some(there), Some(here), None) if !self.numberless => {
                disagree(kit, there, here, page, &section)
            }
            (Some(_), Some(_), Some(_)) => Some("its command is the one in the data file".into()),
            _ => Some("it needs both numbers, there and here, or is numberless".into()),
        }
    }
}

/// What is wrong with a pair of numbers on a section of a page.
fn disagree(kit: &Kit, there: &There, here: &Here, page: &str, section: &str) -> Option<String> {
    let found = match here.read(kit) {
        Ok(found) => found,
        Err(e) => return Some(format!("{e:#}")),
    };
    if there.is != found.is {
        return Some(format!("{} there and {} here are different quantities", there.is, found.is));
    }
    if !numbers(section).iter().any(|number| number.text == there.number) {
        return Some(format!("{page} does not show {}", there.number));
    }
    if printed(section, found.value).is_none() {
        return Some(format!("{page} does not show {:.4}, which is here", found.value));
    }
    not_understood(kit, &found.command)
}

/// How a section prints a value: with as many digits as it does anywhere.
fn printed(section: &str, value: f64) -> Option<&str> {
    let shown = numbers(section).into_iter().filter(|number| number.shows(value));
    shown.map(|number| number.text).max_by_key(|text| text.len())
}

/// The part of a page that `page.md#section` names, or the whole page, in one line.
fn section(kit: &Kit, link: &str) -> Result<String, String> {
    let (page, anchor) = link.split_once('#').unwrap_or((link, ""));
    let text = read_text(&kit.path("book/src").join(page));
    let text = text.map_err(|_| format!("there is no page {page}"))?;
    let section = pages::section(&text, anchor);
    let section = section.ok_or_else(|| format!("{page} has no section #{anchor}"))?;
    Ok(section.replace('\n', " "))
}

/// What is wrong with a command line. That its options are right, the tests of its package say.
fn not_understood(kit: &Kit, command: &str) -> Option<String> {
    let Some(words) = command.strip_prefix("cargo lab ") else {
        return Some(format!("'{command}': not a command of the kit"));
    };
    let name = words.split(' ').next().unwrap_or_default();
    let has = |family: &Family| family.commands.iter().any(|(known, _)| known == name);
    match families(kit) {
        Ok(families) if families.iter().any(has) => None,
        Ok(_) => Some(format!("'{command}': there is no command {name}")),
        Err(e) => Some(format!("{e:#}")),
    }
}

/// Looks at every entry of the list.
///
/// # Errors
/// The list cannot be read. What is wrong in it is returned, a line each.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let faults = read(kit)?.into_iter().filter_map(|figure| {
        let fault = figure.fault(kit)?;
        Some(format!("book/figures.toml: {} {}: {fault}", figure.report, figure.number))
    });
    Ok(faults.collect())
}
