//! Queries for a number of the book, written as words: `lab7-n.json; variant=planned; n=5000; ms`.
//!
//! - `lab7-n.json`: a file of book/data; `compare-soft-*.json`: all files that match;
//!   `published.toml`;
//! - `n=5000`: an entry must have this field ([`crate::entries`]); `n=`: the field can have any
//!   value;
//! - `ms`: the field that is printed. ` / `, ` × ` and ` - ` combine fields, from left to right:
//!   `counters.candidates / steps`. A field with two parts is printed as the least value and the
//!   median: `5.13 (5.60)`;
//! - `over n=1000`: divide by the value of the entry that has this field instead;
//! - `×1000`: multiply by a number;
//! - `.2`: a [format](Format).
//!
//! Of several words of the same kind, the last one counts.

use std::collections::BTreeMap;
use std::rc::Rc;

use anyhow::{Context, Result, ensure};

use crate::digits::Format;
use crate::entries::{Data, Entry};

const OPERATORS: [&str; 3] = [" / ", " × ", " - "];

/// The names of the two parts of a field.
const PARTS: [[&str; 2]; 2] = [["min", "median"], ["of_minima", "of_medians"]];

/// A query.
#[derive(Clone, Default)]
pub(crate) struct Query {
    file: String,
    wanted: BTreeMap<String, String>,
    over: Option<(String, String)>,
    shown: String,
    scale: Option<f64>,
    format: Format,
}

impl Query {
    /// Adds words to the query.
    pub(crate) fn with(mut self, words: &str) -> Self {
        for word in words.split(';').map(str::trim).filter(|word| !word.is_empty()) {
            if word.ends_with(".json") || word.ends_with(".toml") {
                self.file = word.into();
            } else if let Some((name, value)) = word.split_once('=') {
                match name.strip_prefix("over ") {
                    Some(name) => self.over = Some((name.into(), value.into())),
                    None if value.is_empty() => _ = self.wanted.remove(name),
                    None => _ = self.wanted.insert(name.into(), value.into()),
                }
            } else if let Some(scale) = word.strip_prefix('×') {
                self.scale = scale.parse().ok();
            } else if let Some(format) = Format::of(word) {
                self.format = format;
            } else {
                self.shown = word.into();
            }
        }
        self
    }

    /// Returns the answer as a text.
    ///
    /// # Errors
    /// The file cannot be read, or does not have exactly one answer.
    pub(crate) fn answer(&self, data: &mut Data) -> Result<String> {
        let answer = self.any_answer(data)?;
        answer.with_context(|| {
            format!("{} has no '{}' where {:?}", self.file, self.shown, self.wanted)
        })
    }

    /// Returns the answer; `None` if no entry fits.
    ///
    /// # Errors
    /// The file cannot be read, or has several answers.
    pub(crate) fn any_answer(&self, data: &mut Data) -> Result<Option<String>> {
        let entries = data.entries(&self.file)?;
        let fitting = self.fitting(entries);
        let texts = fitting.iter().filter_map(|entry| entry.text(&self.shown));
        if let Some(text) = self.same(texts)? {
            return Ok(Some(text.into()));
        }
        let Some(mut values) = self.value(&fitting)? else { return Ok(None) };
        if let Some((name, value)) = &self.over {
            let mut over = self.clone();
            over.wanted.insert(name.clone(), value.clone());
            let Some(below) = over.value(&over.fitting(entries))? else { return Ok(None) };
            values = combined(&values, " / ", &below);
        }
        let scaled = values.iter().map(|value| self.scale.unwrap_or(1.0) * value);
        let printed: Vec<_> = scaled.map(|value| self.format.print(value)).collect();
        Ok(Some(match &printed[..] {
            [least, median] => format!("{least} ({median})"),
            _ => printed.concat(),
        }))
    }

    /// Returns the entries that have all wanted fields.
    fn fitting<'e>(&self, entries: &'e [Rc<Entry>]) -> Vec<&'e Entry> {
        let entries = entries.iter().map(Rc::as_ref);
        entries.filter(|entry| self.wanted.iter().all(|(name, is)| entry.has(name, is))).collect()
    }

    fn value(&self, fitting: &[&Entry]) -> Result<Option<Vec<f64>>> {
        self.same(fitting.iter().filter_map(|entry| evaluated(entry, &self.shown)))
    }

    /// Returns the item that all items are equal to; `None` if there are no items.
    fn same<T: PartialEq>(&self, mut items: impl Iterator<Item = T>) -> Result<Option<T>> {
        let Some(first) = items.next() else { return Ok(None) };
        let Self { file, shown, wanted, .. } = self;
        let are_equal = items.all(|item| item == first);
        ensure!(are_equal, "{file} has more than one '{shown}' where {wanted:?}");
        Ok(Some(first))
    }
}

/// Returns the value of a formula for an entry; `None` if a field is missing.
fn evaluated(entry: &Entry, formula: &str) -> Option<Vec<f64>> {
    let last = OPERATORS.iter().filter_map(|sign| Some((formula.rfind(sign)?, *sign))).max();
    if let Some((at, sign)) = last {
        let left = evaluated(entry, &formula[..at])?;
        let right = evaluated(entry, &formula[at + sign.len()..])?;
        return Some(combined(&left, sign, &right));
    }
    if let Some(number) = entry.number(formula) {
        return Some(vec![number]);
    }
    let parts = PARTS.iter().map(|parts| {
        parts.iter().filter_map(|part| entry.number(&format!("{formula}.{part}"))).collect()
    });
    parts.into_iter().find(|values: &Vec<f64>| !values.is_empty())
}

/// Combines each value on the left with its partner on the right, or with the only value there.
fn combined(left: &[f64], sign: &str, right: &[f64]) -> Vec<f64> {
    let pairs = left.iter().zip(right.iter().cycle());
    let result = pairs.map(|(left, right)| match sign {
        " / " => left / right,
        " × " => left * right,
        _ => left - right,
    });
    result.collect()
}
