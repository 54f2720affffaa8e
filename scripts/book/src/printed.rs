//! Tables that are filled with numbers from data files: `{{#table WORDS}}`, followed by a table.
//!
//! ```markdown
//! {{#table lab7-n.json}}
//!
//! | N | `planned` | of `outer-dynamic` | report |
//! |---|---|---|---|
//! | n= | variant=planned; ms | variant=planned; ms.min; over variant=outer-dynamic | report_ms_per_step |
//! | 5,000 | {} | {} | {} |
//! | 50,000 | {} | {} | crashes | lab7-n-16-cores.json |
//! ```
//!
//! Each `{}` is replaced by the answer to a [query](crate::query). The query consists of words from
//! four places: the marker, the column, the row, and the braces. The words of the columns are in
//! the row below the dashes, which is not printed. The words of a row are in an additional last
//! cell. If the words of a column end with `=`, each cell of the column completes them.

use anyhow::{Context, Result, bail, ensure};

use lab_kit::Kit;

use crate::entries::Data;
use crate::pages::{Table, pages, tables};
use crate::query::Query;

/// Sections whose tables contain measurements. On pages with names such as `lab1-more.md`, all
/// tables contain measurements.
const MEASURED: [&str; 4] =
    ["## Measure", "## Compare", "## Where it breaks", "## For the curious"];

/// Fills the table at the beginning of a text. Returns the table and the rest of the text.
///
/// # Errors
/// The text does not begin with a table, or a number is not in its file.
pub(crate) fn table<'t>(data: &mut Data, words: &str, text: &'t str) -> Result<(String, &'t str)> {
    let text = text.trim_start();
    let rows = text.split_inclusive('\n').take_while(|line| line.starts_with('|'));
    let (table, after) = text.split_at(rows.map(str::len).sum());
    let rows: Vec<_> = table.lines().map(cells).collect();
    let [titles, rule, columns, rows @ ..] = &rows[..] else { bail!("no table follows {words}") };
    let mut out = line(titles) + &line(rule);
    for row in rows {
        let filled = filled(data, &Query::default().with(words), columns, row);
        out += &line(&filled.with_context(|| format!("table {words}, row {}", row[0]))?);
    }
    Ok((out, after))
}

fn cells(line: &str) -> Vec<&str> {
    let inside = line.trim().strip_prefix('|').unwrap_or(line);
    inside.strip_suffix('|').unwrap_or(inside).split('|').map(str::trim).collect()
}

fn line(cells: &[impl AsRef<str>]) -> String {
    let cells = cells.iter().map(|cell| format!(" {} |", cell.as_ref()));
    format!("|{}\n", cells.collect::<String>())
}

/// Returns a row with its numbers.
fn filled(data: &mut Data, table: &Query, columns: &[&str], row: &[&str]) -> Result<Vec<String>> {
    ensure!((0..=1).contains(&row.len().wrapping_sub(columns.len())), "{} cells", row.len());
    let (cells, own) = row.split_at(columns.len());
    let mut row = String::new();
    for (words, cell) in columns.iter().zip(cells).filter(|(words, _)| words.ends_with('=')) {
        row += &format!("{words}{};", cell.replace(['`', ','], ""));
    }
    row += &own.concat();
    let mut out = Vec::new();
    for (column, cell) in columns.iter().zip(cells) {
        out.push(answered(data, &table.clone().with(column).with(&row), cell)?);
    }
    Ok(out)
}

/// Returns a cell with each `{…}` replaced by its answer.
fn answered(data: &mut Data, query: &Query, cell: &str) -> Result<String> {
    let Some((before, rest)) = cell.split_once('{') else { return Ok(cell.into()) };
    let (words, after) = rest.split_once('}').context("a { has no }")?;
    let answer = query.clone().with(words).answer(data)?;
    Ok(format!("{before}{answer}{}", answered(data, query, after)?))
}

/// Finds tables of measurements with typed numbers. A comment `<!-- no data: why -->` above a table
/// allows them.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for (page, text) in pages(kit)? {
        for table in tables(&text) {
            let measured = page.ends_with("-more.md") || MEASURED.contains(&table.heading);
            if measured && is_typed(&table) {
                let why =
                    "the numbers of this table are typed: print them from data, or say why not";
                wrong.push(format!("{page}:{}: {why}", table.line));
            }
        }
    }
    Ok(wrong)
}

/// Whether the numbers of a table are typed.
///
/// This is so if most cells after the first column have a number, no cell has a query, and no
/// comment gives a reason.
fn is_typed(table: &Table) -> bool {
    let rows = table.rows.iter().skip(2);
    let cells: Vec<&str> = rows.flat_map(|row| row.iter().skip(1).copied()).collect();
    let numbers = cells.iter().filter(|cell| is_number(cell)).count();
    let explained = table.comment.is_some_and(|comment| comment.starts_with("no data: "));
    2 * numbers > cells.len() && !explained && !cells.iter().any(|cell| cell.contains('{'))
}

/// Whether a cell has a digit outside of formulas.
fn is_number(cell: &str) -> bool {
    cell.contains(|c: char| c.is_ascii_digit()) && !cell.contains('$')
}

#[cfg(test)]
mod tests {
    use super::{check, table};
    use crate::entries::Data;
    use lab_kit::Kit;

    const RACE: &str = r#"{"results": {"runs": [
        {"program": "solution1:a,t=1", "n": 5000, "seconds": {"min": 0.25, "median": 0.3}, "steps": 5, "held_by": "x"},
        {"program": "solution1:a,t=2", "n": 5000, "seconds": {"min": 0.125, "median": 0.2}, "steps": 5},
        {"program": "solution1:a,t=1", "n": 6000, "seconds": {"min": 7.0, "median": 8.0}, "steps": 5}
    ]}}"#;
    const PUBLISHED: &str = "[growth.r-growth]\nname = 'R'\npoints = [[5000, 1.5], [6000, 0.5]]\n";

    fn with<T>(page: &str, test: impl FnOnce(&Kit) -> T) -> T {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("book/data/race.json", RACE),
            ("book/published.toml", PUBLISHED),
            ("book/src/lab1.md", page),
        ];
        test(&Kit::of_files(folder.path(), &files))
    }

    fn printed(words: &str, rows: &str) -> anyhow::Result<String> {
        let text = format!("\n\n{rows}\nText.");
        with("", |kit| Ok(table(&mut Data::new(kit), words, &text)?.0))
    }

    #[test]
    fn words_of_table_column_row_and_cell_find_a_number() {
        let rows = "| n | one | of one | there |\n|---|---|---|---|\n\
            | n= | t=1; ms | t=2; ms.min; over t=1; .2 | published.toml; list=r-growth.points; ms |\n\
            | 5,000 | {} | {} | {} |\n\
            | 6,000 | **{n=5000; held_by}** | *none* | here {seconds.min × steps / n} | ms.min; .0 |\n";
        let expected = "| n | one | of one | there |\n| --- | --- | --- | --- |\n\
            | 5,000 | 50.0 (60.0) | 0.50 | 1.50 |\n\
            | 6,000 | **x** | *none* | here 0 |\n";
        assert_eq!(printed("race.json", rows).unwrap(), expected);
    }

    #[test]
    fn exactly_one_number_must_be_found() {
        for (cell, why) in [
            ("{}", "row 5,000: race.json has more than one 'ms'"),
            ("{t=3}", "race.json has no 'ms' where"),
            ("{t=1; gone.json}", "gone.json"),
            ("1 | 2 | 3", "4 cells"),
        ] {
            let rows = format!("| n | ms |\n|---|---|\n| n= | ms |\n| 5,000 | {cell} |\n");
            let fault = format!("{:#}", printed("race.json", &rows).unwrap_err());
            assert!(fault.contains(why), "{fault}");
        }
    }

    #[test]
    fn a_table_of_measurements_is_printed_or_says_why_not() {
        let page = "## Measure\n\nText.\n\n| n | ms |\n|---|---|\n| 5 | 1.25 |\n";
        for (part, other, is_wrong) in [
            ("", "", true),
            ("Text.", "<!-- no data: a formula -->", false),
            ("Measure", "Build", false),
            ("| 1.25 |", "| {} |", false),
        ] {
            let faults = with(&page.replacen(part, other, 1), |kit| check(kit).unwrap());
            assert_eq!(faults.concat().contains("lab1.md:5: the numbers"), is_wrong, "{faults:?}");
        }
    }
}
