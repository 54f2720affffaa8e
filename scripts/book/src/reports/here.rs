//! A number of the kit's own, read from a data file.
//!
//! ```toml
//! here = { data = "lab7-n.json", row = "runs variant=outer-dynamic n=20000", column = "least" }
//! ```
//!
//! A row is found from the file's `results`, word by word: `runs` goes into a field, and `n=20000` keeps the entries
//! whose field has this value. Exactly one entry must be left.

use anyhow::{Context, Result, bail};
use serde::Deserialize;
use serde_json::Value;

use lab_kit::Kit;
use lab_kit::files::read_text;

/// Where a number stands.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Here {
    /// A file of book/data.
    data: String,
    row: String,
    /// One of those that [`cell`] knows, such as `least` or `own efficiency`, or a counter.
    column: String,
    /// Another row of the file: the number is how many times as fast as that one this row is, with the column
    /// `speed-up`, or `efficiency`, which is the speed-up over the threads.
    over: Option<String>,
}

/// What was found.
pub(super) struct Number {
    pub(super) value: f64,
    /// Its quantity and unit.
    pub(super) is: &'static str,
    /// What made the file.
    pub(super) command: String,
}

impl Here {
    /// Reads it.
    ///
    /// # Errors
    /// The file cannot be read, or has no such row or column.
    pub(super) fn read(&self, kit: &Kit) -> Result<Number> {
        let path = kit.path("book/data").join(&self.data);
        let file: Value =
            serde_json::from_str(&read_text(&path)?).with_context(|| path.display().to_string())?;
        let results =
            file.get("results").with_context(|| format!("{} has no results", self.data))?;
        let row = self.find(results, &self.row)?;
        let cell = match &self.over {
            Some(over) => compared(row, self.find(results, over)?, &self.column),
            None => cell(row, &self.column),
        };
        let (value, is) =
            cell.with_context(|| format!("{} has no column '{}'", self.data, self.column))?;
        let command = file.get("command").and_then(Value::as_str);
        let command = command.with_context(|| format!("{} names no command", self.data))?;
        Ok(Number { value, is, command: repeated(command) })
    }

    fn find<'r>(&self, results: &'r Value, row: &str) -> Result<&'r Value> {
        let mut left = vec![results];
        for word in row.split_whitespace() {
            left = match word.split_once('=') {
                Some((name, value)) => {
                    left.retain(|entry| field(entry, name).is_some_and(|found| is(found, value)));
                    left
                }
                None => {
                    left.into_iter().filter_map(|entry| entry.get(word)).flat_map(entries).collect()
                }
            };
        }
        match left[..] {
            [row] => Ok(row),
            [] => bail!("{} has no row '{row}'", self.data),
            _ => bail!("{} has {} rows '{row}'", self.data, left.len()),
        }
    }
}

/// A field, or a field of a field: `scene.soft.n`.
fn field<'r>(entry: &'r Value, name: &str) -> Option<&'r Value> {
    name.split('.').try_fold(entry, |entry, name| entry.get(name))
}

fn entries(value: &Value) -> Vec<&Value> {
    value.as_array().map_or_else(|| vec![value], |entries| entries.iter().collect())
}

fn is(found: &Value, value: &str) -> bool {
    match found {
        Value::String(text) => text == value,
        _ => found.as_f64().zip(value.parse().ok()).is_some_and(|(a, b): (f64, f64)| a == b),
    }
}

fn number(row: &Value, name: &str) -> Option<f64> {
    row.get(name).and_then(Value::as_f64)
}

fn ms_a_step(row: &Value) -> Option<f64> {
    Some(1e3 * number(row.get("seconds")?, "min")? / number(row, "steps")?)
}

/// A column of a row, with its quantity and unit.
fn cell(row: &Value, column: &str) -> Option<(f64, &'static str)> {
    let efficiency = |name| Some((number(row, name)?, "efficiency"));
    match column {
        "least" => Some((ms_a_step(row)?, "ms a step")),
        "own efficiency" => efficiency("own_efficiency"),
        "average strong efficiency" => efficiency("average_strong_efficiency"),
        "speed-up" => Some((number(row, "own_efficiency")? * number(row, "workers")?, "speed-up")),
        "slope" => Some((number(row, "slope_by_time")?, "slope")),
        counter => {
            let unit = if counter.ends_with("[s]") { "s" } else { "count" };
            Some((number(row.get("counters")?, counter)?, unit))
        }
    }
}

/// How many times as fast as the row `over` a row is.
fn compared(row: &Value, over: &Value, column: &str) -> Option<(f64, &'static str)> {
    let speed_up = ms_a_step(over)? / ms_a_step(row)?;
    match column {
        "speed-up" => Some((speed_up, "speed-up")),
        "efficiency" => Some((speed_up / number(row, "threads")?, "efficiency")),
        _ => None,
    }
}

/// The command as one would repeat it: without the files that it wrote.
fn repeated(command: &str) -> String {
    let mut words = command.split_whitespace();
    let mut kept = Vec::new();
    while let Some(word) = words.next() {
        if ["--json", "--svg"].contains(&word) {
            words.next();
        } else {
            kept.push(word);
        }
    }
    kept.join(" ")
}
