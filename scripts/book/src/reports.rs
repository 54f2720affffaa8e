//! Nothing of the course reports is lost: book/figures.toml lists every table, figure, claim and
//! wish of theirs, with the command that makes it again here and the page that shows both numbers.

use anyhow::{Result, bail};
use serde::Deserialize;

use lab_kit::Kit;
use lab_kit::command::{Family, families};
use lab_kit::files::{read_text, read_toml};

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
    /// What makes it again, with the kit's own numbers; none for a drawing made by hand.
    command: Option<String>,
    /// The file in book/src that shows both; a `#section` may follow.
    page: Option<String>,
    /// A number of theirs, as the page shows it.
    there: Option<String>,
    /// The kit's own beside it.
    here: Option<String>,
    /// It has no numbers: the page shows how it is done here.
    #[serde(default)]
    numberless: bool,
    /// Why it is not made again.
    left_out: Option<String>,
}

fn read(kit: &Kit) -> Result<Vec<Figure>> {
    Ok(read_toml::<List>(&kit.path("book/figures.toml"))?.figure)
}

/// The table of what became of each table and figure, of one report or (with an empty name) all.
///
/// # Errors
/// The list cannot be read, or there is no such report.
pub(crate) fn table(kit: &Kit, report: &str) -> Result<String> {
    let figures = read(kit)?;
    let mut out = String::new();
    for (name, title) in REPORTS {
        if !report.is_empty() && report != name {
            continue;
        }
        out.push_str(&format!("\n## {title}\n\n| there | what | here |\n|---|---|---|\n"));
        for figure in figures.iter().filter(|f| f.report == name) {
            out.push_str(&format!("| {} | {} | {} |\n", figure.number, figure.what, figure.here()));
        }
    }
    if out.is_empty() {
        bail!("there is no report '{report}'");
    }
    Ok(out)
}

impl Figure {
    fn here(&self) -> String {
        match (&self.page, &self.command, &self.left_out) {
            (_, _, Some(why)) => format!("left out: {why}"),
            (Some(page), Some(command), None) => {
                let numbers = self.there.as_ref().zip(self.here.as_ref());
                let link =
                    numbers.map_or("page".into(), |(there, here)| format!("{there} – {here}"));
                format!("[{link}]({page}), `{command}`")
            }
            (Some(page), None, None) => format!("[page]({page})"),
            (None, ..) => "missing".into(),
        }
    }

    /// What is wrong with this entry.
    fn fault(&self, kit: &Kit) -> Option<String> {
        if !REPORTS.iter().any(|(name, _)| *name == self.report) {
            return Some("no such report".into());
        }
        match (&self.page, &self.left_out) {
            (None, Some(_)) if self.command.is_none() => return None,
            (Some(_), None) => {}
            _ => return Some("it needs either a page or a reason why it is left out".into()),
        }
        let page = self.page.as_deref().unwrap_or_default().split('#').next().unwrap_or_default();
        let Ok(text) = read_text(&kit.path("book/src").join(page)) else {
            return Some(format!("there is no page {page}"));
        };
        match &self.command {
            Some(command) => {
                if let Err(why) = understood(kit, command) {
                    return Some(format!("'{command}': {why}"));
                }
            }
            // A drawing is made by hand.
            None if self.numberless => {}
            None => return Some("no command makes it again".into()),
        }
        match (&self.there, &self.here) {
            (None, None) if self.numberless => None,
            (Some(there), Some(here)) if !self.numberless => {
                let missing = [there, here].into_iter().find(|number| !shows(&text, number))?;
                Some(format!("{page} does not show {missing}"))
            }
            _ => Some("it needs both numbers, there and here, or is numberless".into()),
        }
    }
}

/// Whether a page shows a number: these digits, and no more of them on either side.
fn shows(page: &str, number: &str) -> bool {
    let inside = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    page.split(|c| !inside(c)).any(|word| word.trim_matches(['.', ',']) == number)
}

/// Whether the kit would understand a command line.
fn understood(kit: &Kit, command: &str) -> Result<(), String> {
    let words: Vec<&str> = command.split_whitespace().take_while(|word| *word != "<").collect();
    match words[..] {
        ["cargo", "lab", ref arguments @ ..] => {
            let name = arguments.first().copied().unwrap_or_default();
            let families = families(kit).map_err(|e| format!("{e:#}"))?;
            let has = |family: &Family| family.commands.iter().any(|(known, _)| known == name);
            // That its options are right, the tests of its package say.
            families
                .iter()
                .any(has)
                .then_some(())
                .ok_or_else(|| format!("there is no command {name}"))
        }
        ["cargo", "run", "--release", "-p", package, ..] => {
            let lab = package.strip_prefix("solution").and_then(|lab| lab.parse().ok());
            match lab {
                Some(lab) if kit.solution(lab).join("Cargo.toml").is_file() => Ok(()),
                _ => Err(format!("there is no package {package}")),
            }
        }
        _ => Err("not a command of the kit".into()),
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

#[cfg(test)]
mod tests {
    use super::{check, table};
    use lab_kit::Kit;

    /// A kit with a chapter and a solution of lab 1, and one figure.
    fn with(entry: &str, test: impl FnOnce(&Kit)) {
        let folder = tempfile::tempdir().unwrap();
        let tool = "[package]\nname = 'tool'\n[package.metadata.lab]\ntitle = 'Tool'\ncommands = [['run', 'Run']]";
        let entry =
            format!("[[figure]]\nreport = 'cs267'\nnumber = 'Table 1'\nwhat = 'times'\n{entry}");
        let files = [
            ("book/src/lab1.md", "They print 1.25, we 2,500 (3)."),
            ("solutions/lab1/Cargo.toml", ""),
            ("Cargo.toml", "[workspace]\nmembers = ['tool']"),
            ("tool/Cargo.toml", tool),
            ("book/figures.toml", &entry),
        ];
        test(&Kit::of_files(folder.path(), &files));
    }

    fn fault(entry: &str) -> String {
        let mut fault = String::new();
        with(entry, |kit| fault = check(kit).unwrap().join("\n"));
        fault
    }

    #[test]
    fn a_figure_has_a_page_and_a_command_or_a_reason() {
        let drawing = "page = 'lab1.md#measure'\nnumberless = true";
        let drawn_by = |command| fault(&format!("{drawing}\ncommand = '{command}'"));
        assert_eq!(drawn_by("cargo lab run 1 -n 500"), "");
        assert_eq!(drawn_by("cargo run --release -p solution1 -- -n 5"), "");
        assert_eq!(fault(drawing), "", "by hand");
        assert_eq!(fault("left_out = 'a logo'"), "");
        assert!(fault("").contains("needs either"));
        assert!(fault("page = 'lab1.md'").contains("no command"));
    }

    #[test]
    fn the_table_shows_both_numbers() {
        with("page = 'lab1.md'\ncommand = 'cargo lab run 1'\nthere = '1.25'\nhere = '3'", |kit| {
            assert!(
                table(kit, "cs267").unwrap().contains("| [1.25 – 3](lab1.md), `cargo lab run 1` |")
            );
        });
    }

    #[test]
    fn the_page_shows_both_numbers() {
        let row = "page = 'lab1.md'\ncommand = 'cargo lab run 1'\n";
        let numbers = |there, here| fault(&format!("{row}there = '{there}'\nhere = '{here}'"));
        assert_eq!(numbers("1.25", "2,500"), "");
        assert_eq!(numbers("1.25", "3"), "");
        for number in ["1.2", "25", "500", "1.3"] {
            assert!(numbers(number, "3").contains(&format!("does not show {number}")), "{number}");
            assert!(numbers("3", number).contains(&format!("does not show {number}")), "{number}");
        }
        assert!(fault(row).contains("both numbers"));
        assert!(fault(&format!("{row}there = '3'")).contains("both numbers"));
        assert!(
            fault(&format!("{row}there = '3'\nhere = '3'\nnumberless = true")).contains("both")
        );
    }

    #[test]
    fn the_command_must_parse_and_the_page_exist() {
        assert!(fault("page = 'lab1.md'\ncommand = 'cargo lab dance 1'").contains("dance"));
        assert!(fault("page = 'lab1.md'\ncommand = 'make plots'").contains("not a command"));
        assert!(
            fault("page = 'lab1.md'\ncommand = 'cargo run --release -p solution3'")
                .contains("solution3")
        );
        assert!(fault("page = 'lab9.md'\ncommand = 'cargo lab run 1'").contains("no page lab9.md"));
    }

    #[test]
    fn the_table_names_what_is_left_out() {
        with("left_out = 'a logo'", |kit| {
            assert!(
                table(kit, "cs267").unwrap().contains("| Table 1 | times | left out: a logo |")
            );
            assert!(table(kit, "cs999").is_err());
        });
    }
}
