//! Checks that every result of the course reports has its place in the kit.
//!
//! book/figures.toml lists every table, figure, claim and open question of the reports. Each entry
//! names the page of the book that shows the same result. It also contains a number of the report,
//! and the kit's number for the same quantity.

use std::collections::BTreeMap;

use anyhow::Result;
use serde::Deserialize;

use lab_kit::Kit;
use lab_kit::command::families;
use lab_kit::files::read_toml;

use crate::entries::Data;
use crate::pages::section;
use crate::query::Query;

/// The reports' names in figures.toml, and their titles.
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

/// A table or figure of a report, or one of its claims or plans for future work.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Figure {
    report: String,
    /// Number of the table or figure in the report, such as `Table 2`.
    number: String,
    what: String,
    /// The page in book/src that shows the result, with or without a `#section`.
    page: Option<String>,
    numbers: Option<Numbers>,
    /// The command that reproduces the page, if the page has no numbers; `None` for a drawing by
    /// hand.
    command: Option<String>,
    /// The reason why the kit does not reproduce the result.
    left_out: Option<String>,
}

/// A number of the report and the kit's number for the same quantity.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Numbers {
    is: String,
    there: String,
    /// The query for the kit's number.
    here: String,
}

fn read(kit: &Kit) -> Result<Vec<Figure>> {
    Ok(read_toml::<List>(&kit.path("book/figures.toml"))?.figure)
}

/// Returns a table that lists all tables and figures of the reports, and their places in the kit.
///
/// # Errors
/// The list cannot be read, or a number is not in its data file.
pub(crate) fn table(data: &mut Data) -> Result<String> {
    let figures = read(data.kit)?;
    let mut out = String::new();
    for (name, title) in REPORTS {
        out += &format!(
            "\n## {title}\n\n| there | what | theirs | ours | here |\n|---|---|---:|---:|---|\n"
        );
        for figure in figures.iter().filter(|figure| figure.report == name) {
            let Here { theirs, ours, shown } = figure.here(data)?;
            let Figure { number, what, .. } = figure;
            out += &format!("| {number} | {what} | {theirs} | {ours} | {shown} |\n");
        }
    }
    Ok(out)
}

/// The kit's counterpart of a table or figure of a report.
#[derive(Default)]
struct Here {
    /// The report's number; empty if no numbers are compared.
    theirs: String,
    /// The kit's number; empty if no numbers are compared.
    ours: String,
    /// The page that shows the result and the command that makes it, or the reason why the result
    /// is left out.
    shown: String,
}

impl Figure {
    fn here(&self, data: &mut Data) -> Result<Here> {
        let page = self.page.as_deref().unwrap_or_default();
        let shown = match (&self.left_out, &self.numbers, &self.command) {
            (Some(why), ..) => format!("left out: {why}"),
            (_, Some(Numbers { is, there, here }), _) => {
                let here = Query::default().with(here);
                let command = repeated(&here.clone().with("command").answer(data)?);
                let shown = format!("[{is}]({page}), `{command}`");
                return Ok(Here { theirs: there.clone(), ours: here.answer(data)?, shown });
            }
            (_, _, Some(command)) => format!("[page]({page}), `{command}`"),
            _ => format!("[page]({page})"),
        };
        Ok(Here { shown, ..Here::default() })
    }
}

/// Checks every entry of the list against the printed pages. Returns the faults, one per line.
///
/// # Errors
/// The list cannot be read, or a number is not in its data file.
pub(crate) fn check(data: &mut Data, pages: &BTreeMap<String, String>) -> Result<Vec<String>> {
    let families = families(data.kit)?;
    let commands: Vec<_> = families.iter().flat_map(|family| &family.commands).collect();
    let mut wrong = Vec::new();
    for figure in read(data.kit)? {
        let here = figure.here(data)?;
        let link = figure.page.as_deref().unwrap_or_default();
        let (page, anchor) = link.split_once('#').unwrap_or((link, ""));
        let text = pages.get(&format!("book/src/{page}")).and_then(|text| section(text, anchor));
        let named =
            here.shown.split("`cargo lab ").nth(1).and_then(|line| line.split([' ', '`']).next());
        let fault = if !REPORTS.iter().any(|(name, _)| *name == figure.report) {
            "there is no such report".into()
        } else if text.is_none() && (figure.left_out.is_none() || figure.page.is_some()) {
            format!("'{link}' is not a page of the book")
        } else if !here.is_in(&text.unwrap_or_default()) {
            format!("{link} does not show both numbers, {} and {}", here.theirs, here.ours)
        } else if named.is_some_and(|name| !commands.iter().any(|(known, _)| known == name)) {
            format!("there is no command in {}", here.shown)
        } else {
            continue;
        };
        wrong.push(format!("book/figures.toml: {} {}: {fault}", figure.report, figure.number));
    }
    Ok(wrong)
}

impl Here {
    /// Whether a text contains both numbers as they are printed. Also true if there are no numbers.
    fn is_in(&self, text: &str) -> bool {
        let words = text.split(|c: char| !c.is_ascii_digit() && !".,".contains(c));
        let words: Vec<_> = words.map(|word| word.trim_matches(['.', ','])).collect();
        [&self.theirs, &self.ours].iter().all(|n| n.is_empty() || words.contains(&n.as_str()))
    }
}

/// Returns the command without the options for files, so that a reader can repeat it.
fn repeated(command: &str) -> String {
    let mut words: Vec<_> = command.split_whitespace().collect();
    while let Some(at) = words.iter().position(|word| ["--json", "--svg"].contains(word)) {
        words.drain(at..(at + 2).min(words.len()));
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::{check, table};
    use crate::entries::Data;
    use crate::pages::pages;
    use lab_kit::Kit;

    const TOOL: &str =
        "[package]\nname = 'tool'\n[package.metadata.lab]\ncommands = [['run', 'Run']]";
    const PAGE: &str =
        "# They\n\n## They, us\n\nThey print 1.25, we 2,500 (3).\n\n## Others\n\n7.\n";
    const RACE: &str = r#"{"command": "cargo lab run 1 --json race.json -n 9", "results": {"runs": [
        {"program": "solution1:a", "seconds": {"min": 5.0}, "steps": 2},
        {"program": "solution1:b", "seconds": {"min": 2.0}, "steps": 2}
    ]}}"#;
    const PAIR: &str = "page = 'lab1.md'\n\
        numbers = { is = 'ms a step', there = '1.25', here = 'race.json; variant=a; ms' }";

    fn with<T>(entry: &str, test: impl FnOnce(&Kit) -> T) -> T {
        let folder = tempfile::tempdir().unwrap();
        let figures =
            format!("[[figure]]\nreport = 'cs267'\nnumber = 'Table 1'\nwhat = 'times'\n{entry}");
        let files = [
            ("Cargo.toml", "[workspace]\nmembers = ['tool']"),
            ("tool/Cargo.toml", TOOL),
            ("book/src/lab1.md", PAGE),
            ("book/data/race.json", RACE),
            ("book/figures.toml", &figures),
        ];
        test(&Kit::of_files(folder.path(), &files))
    }

    #[test]
    fn the_table_shows_both_numbers_or_why_there_are_none() {
        for (entry, shown) in [
            (PAIR, "| times | 1.25 | 2,500 | [ms a step](lab1.md), `cargo lab run 1 -n 9` |"),
            (
                "page = 'lab1.md'\ncommand = 'cargo lab run'",
                "| times |  |  | [page](lab1.md), `cargo lab run` |",
            ),
            ("left_out = 'a logo'", "| Table 1 | times |  |  | left out: a logo |"),
        ] {
            let table = with(entry, |kit| table(&mut Data::new(kit)).unwrap());
            assert!(table.contains(shown), "{table}");
        }
    }

    #[test]
    fn what_is_shown_is_on_the_page() {
        for (part, other, why) in [
            ("", "", ""),
            ("lab1.md", "lab1.md#they-us", ""),
            ("1.25", "2.5", "does not show both"),
            ("=a", "=b", "does not show both numbers, 1.25 and 1,000"),
            ("lab1.md", "lab1.md#others", "lab1.md#others does not show both"),
            ("lab1.md", "lab1.md#gone", "'lab1.md#gone' is not a page"),
            ("page = 'lab1.md'", "", "'' is not a page"),
            (PAIR, "page = 'lab1.md'\ncommand = 'cargo lab dance 1'", "no command in [page]"),
        ] {
            let entry = PAIR.replacen(part, other, 1);
            let faults = with(&entry, |kit| check(&mut Data::new(kit), &pages(kit).unwrap()));
            let faults = faults.unwrap().join("\n");
            assert!(faults.contains(why) && faults.is_empty() == why.is_empty(), "{faults}");
        }
    }
}
