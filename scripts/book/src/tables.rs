//! A number in a table of the book stands in the data file that the comment above the table names.
//!
//! ```markdown
//! <!-- data: lab2-race.json; not: ratio, spread -->
//!
//! | program | least | ratio |
//! ```
//!
//! Files are those of `book/data`, and `published.toml`. What stands in the columns after `not:` is
//! worked out from other columns, and the first column says what a row is about. A table without
//! such a comment may say `<!-- no data: why -->`; one of chapter's measurements must say either.

use anyhow::{Context, Result};
use serde_json::{Map, Value};

use lab_kit::Kit;
use lab_kit::files::{read_text, read_toml};

use crate::pages::{Table, pages, tables};

/// Sections of a chapter whose tables hold measurements. So do all tables of a chapter's page for the curious.
const MEASURED: [&str; 4] =
    ["## Measure", "## Compare", "## Where it breaks", "## For the curious"];

/// Looks at the tables of every page.
///
/// # Errors
/// A page cannot be read. What is wrong is returned, a line each.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    for (page, text) in pages(kit)? {
        for table in tables(&text) {
            let measured = page.ends_with("-more.md") || MEASURED.contains(&table.heading);
            let faults = faults(kit, &table, measured);
            wrong.extend(faults.into_iter().map(|why| format!("{page}:{}: {why}", table.line)));
        }
    }
    Ok(wrong)
}

/// The files that a comment names, and the columns that are not theirs; no files where it says why there are none.
fn read_source(comment: &str) -> Option<(Vec<&str>, Vec<&str>)> {
    if comment.strip_prefix("no data: ").is_some_and(|why| !why.is_empty()) {
        return Some((Vec::new(), Vec::new()));
    }
    let source = comment.strip_prefix("data: ")?;
    let (files, not) = source.split_once("; not: ").unwrap_or((source, ""));
    let files: Vec<&str> = files.split_whitespace().collect();
    let not = not.split(", ").filter(|word| !word.is_empty()).collect();
    (!files.is_empty()).then_some((files, not))
}

fn faults(kit: &Kit, table: &Table, measured: bool) -> Vec<String> {
    let [header, _, rows @ ..] = &table.rows[..] else { return Vec::new() };
    let Some((files, not)) = table.comment.and_then(read_source) else {
        let cells: Vec<&str> = rows.iter().flat_map(|row| row.iter().skip(1).copied()).collect();
        let full = cells.iter().filter(|cell| !numbers(cell).is_empty()).count();
        let needs_one = measured && 2 * full > cells.len();
        let why = "the comment above this table names no data file and no reason";
        return needs_one.then(|| why.into()).into_iter().collect();
    };
    if files.is_empty() {
        return Vec::new();
    }
    let mut known = Vec::new();
    for file in files {
        if let Err(e) = read(kit, file, &mut known) {
            return vec![format!("{e:#}")];
        }
    }
    let mut wrong = Vec::new();
    for row in rows {
        for (title, cell) in header.iter().zip(row).skip(1) {
            if not.contains(title) {
                continue;
            }
            for number in numbers(cell) {
                if !known.iter().any(|value| number.rounds(*value)) {
                    wrong.push(format!("{} ({title}, {}) is not in the data", number.text, row[0]));
                }
            }
        }
    }
    wrong
}

/// All numbers of a data file, and those that a table of times shows of them.
fn read(kit: &Kit, file: &str, known: &mut Vec<f64>) -> Result<()> {
    let published = file == "published.toml";
    let path = kit.path(if published { "book" } else { "book/data" }).join(file);
    let value: Value = if published {
        read_toml(&path)?
    } else {
        serde_json::from_str(&read_text(&path)?).with_context(|| path.display().to_string())?
    };
    let from = known.len();
    collect(&value, known);
    if published {
        // Hard discs: its seconds of 50 steps are milliseconds of one here.
        let steps: Vec<f64> = known[from..].iter().map(|seconds| seconds * 1e3 / 50.0).collect();
        known.extend(steps);
    }
    Ok(())
}

fn collect(value: &Value, known: &mut Vec<f64>) {
    match value {
        Value::Number(number) => known.extend(number.as_f64()),
        Value::Array(items) => items.iter().for_each(|item| collect(item, known)),
        Value::Object(fields) => {
            known.extend(of_a_run(fields));
            fields.values().for_each(|field| collect(field, known));
        }
        _ => {}
    }
}

/// Of a run that was timed: milliseconds of a step, or of the run if it does not say its steps; and
/// what it counted, per step and particle, seconds in milliseconds.
fn of_a_run(fields: &Map<String, Value>) -> Vec<f64> {
    let number = |value: &Value, name: &str| value.get(name).and_then(Value::as_f64);
    let Some(seconds) = fields.get("seconds") else { return Vec::new() };
    let steps = fields.get("steps").and_then(Value::as_f64).unwrap_or(1.0);
    let times = ["min", "median"].into_iter().filter_map(|name| number(seconds, name));
    let mut shown: Vec<f64> = times.map(|seconds| 1e3 * seconds / steps).collect();
    let scene = fields.get("scene").and_then(|scene| scene.as_object()?.values().next());
    let n = scene.and_then(|scene| number(scene, "n")).unwrap_or(f64::NAN);
    if let Some(Value::Object(counters)) = fields.get("counters") {
        for (name, counted) in counters {
            let unit = if name.ends_with("[s]") { 1e3 } else { 1.0 };
            let counted = unit * counted.as_f64().unwrap_or(f64::NAN) / steps;
            shown.extend([counted, counted / n]);
        }
    }
    shown
}

/// A number as it is printed.
#[derive(Debug, PartialEq)]
pub(crate) struct Printed<'t> {
    pub(crate) text: &'t str,
    value: f64,
    /// Half a unit of its last digit.
    half: f64,
}

impl Printed<'_> {
    fn rounds(&self, value: f64) -> bool {
        (self.value - value).abs() <= self.half * (1.0 + 1e-9)
    }

    /// Whether it is the value rounded to two digits at least.
    pub(crate) fn shows(&self, value: f64) -> bool {
        self.rounds(value) && self.half <= 0.05 * value.abs()
    }
}

/// The numbers of a cell. What stands between back quotes is no number.
pub(crate) fn numbers(cell: &str) -> Vec<Printed<'_>> {
    let plain = cell.split('`').step_by(2).flat_map(|text| text.split([' ', '(', ')', '*']));
    let words: Vec<&str> = plain
        .map(|word| word.trim_end_matches([',', ';', '.']))
        .filter(|word| !word.is_empty())
        .collect();
    let scales = words.iter().skip(1).chain([&""]).map(|unit| match *unit {
        "M" => 1e6,
        "%" => 1e-2,
        _ => 1.0,
    });
    words.iter().zip(scales).filter_map(|(word, scale)| printed(word, scale)).collect()
}

fn printed(text: &str, scale: f64) -> Option<Printed<'_>> {
    text.contains(|c: char| c.is_ascii_digit()).then_some(())?;
    let digits = text.replace(',', "").replace('−', "-");
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let exponent: i32 = exponent.parse().ok()?;
    let value: f64 = mantissa.parse().ok().filter(|value: &f64| value.is_finite())?;
    let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i32);
    let unit = scale * 10f64.powi(exponent);
    Some(Printed { text, value: value * unit, half: 0.5 * unit * 10f64.powi(-decimals) })
}

#[cfg(test)]
mod tests {
    use super::{check, numbers};
    use lab_kit::Kit;

    const DATA: &str = r#"{"runs": [{"seconds": {"min": 0.25, "median": 0.3}, "steps": 5, "ratio": 1.2345,
        "counters": {"pair tests": 10000}, "scene": {"soft": {"n": 1000}}}]}"#;

    fn faults(chapter: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("book/data/race.json", DATA),
            ("book/published.toml", "[a]\npoints = [[5, 43.35]]\n"),
            ("book/src/lab1.md", chapter),
        ];
        check(&Kit::of_files(folder.path(), &files)).unwrap()
    }

    fn table(comment: &str, cell: &str) -> String {
        format!(
            "## Measure\n\n{comment}\n\n| program | ms a step |\n|---|---:|\n| `t=2` 99 | {cell} |\n"
        )
    }

    #[test]
    fn a_number_must_be_in_the_data_as_it_is_rounded() {
        let data = "<!-- data: race.json published.toml -->";
        for cell in ["50.0 (60.0)", "50", "1.23", "2.0", "", "none", "**1.2**", "867", "123 %"] {
            assert_eq!(faults(&table(data, cell)), [""; 0], "{cell}");
        }
        for cell in ["51.0", "50.0 (61)", "1.24", "1.235e1", "43.2"] {
            let faults = faults(&table(data, cell));
            assert_eq!(faults.len(), 1, "{cell}: {faults:?}");
            assert!(faults[0].starts_with("book/src/lab1.md:5: "), "{faults:?}");
        }
        assert_eq!(faults(&table("<!-- data: race.json; not: ms a step -->", "77")), [""; 0]);
        assert!(faults(&table("<!-- data: gone.json -->", "50"))[0].contains("gone.json"));
    }

    #[test]
    fn a_table_of_measurements_says_where_they_are_from() {
        assert!(faults(&table("", "50"))[0].contains("names no data file"));
        assert!(
            faults(&table("<!-- data: race.json -->\n\nWords.", "50"))[0].contains("no data file")
        );
        assert_eq!(faults(&table("<!-- no data: of the report -->", "51")), [""; 0]);
        assert_eq!(faults(&table("", "words")), [""; 0]);
        assert_eq!(faults(&table("", "50").replace("Measure", "Build")), [""; 0]);
    }

    #[test]
    fn numbers_as_tables_print_them() {
        let values = |cell| numbers(cell).iter().map(|n| (n.value, n.half)).collect::<Vec<_>>();
        assert_eq!(values("1,239 (0.5)"), [(1239.0, 0.5), (0.5, 0.05)]);
        assert_eq!(values("50 M, −3 %, 2e-3"), [(5e7, 5e5), (-0.03, 0.005), (0.002, 0.0005)]);
        assert_eq!(values("`t=2` 1 `3`"), [(1.0, 0.5)]);
        assert_eq!(values("p1d: none, 10⁶"), []);
    }
}
