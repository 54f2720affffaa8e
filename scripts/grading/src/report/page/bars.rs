//! Bar charts of a class: the distribution of points, and the tasks.

use std::collections::BTreeMap;

use maud::{Markup, html};

use crate::record::Record;
use crate::report::Words;
use lab_kit::escape::{cut, line};

/// Maximal number of characters of a message that are shown.
const SHOWN: usize = 200;

/// Number of bars in the histogram.
const BARS: usize = 10;

/// Draws the number of submissions for each range of points.
pub(crate) fn histogram(records: &[Record], full: f64) -> Markup {
    let mut counts = [0_usize; BARS];
    for record in records {
        counts[((record.marked.points / full * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    html! {
        h2 { "Points" }
        svg viewBox="0 0 320 120" role="img"
            aria-label="How many submissions got which share of the points" {
            line x1="0" x2="320" y1="100" y2="100" {}
            @for (bar, count) in counts.iter().enumerate() {
                @let x = bar * 32;
                @let height = 80.0 * *count as f64 / most;
                @if *count > 0 {
                    rect x=(x + 3) y=(tenths(100.0 - height)) width="26" height=(tenths(height)) {}
                    text x=(x + 16) y=(tenths(96.0 - height)) text-anchor="middle" { (count) }
                }
                text x=(x) y="115" { (100 / BARS * bar) }
            }
            text x="320" y="115" text-anchor="end" { "%" }
        }
    }
}

/// Formats a length with one decimal.
fn tenths(length: f64) -> String {
    format!("{length:.1}")
}

/// Draws the number of submissions that solve each task. Adds the most frequent message that the
/// other submissions got.
pub(crate) fn tasks(records: &[Record], words: &Words) -> Markup {
    let tasks = records.first().map_or(&[][..], |first| &first.tasks);
    html! {
        h2 { "Tasks" }
        ul.bars {
            @for task in tasks {
                @let have = having(records, &task.id);
                li {
                    span { (words.task(&task.id)) }
                    (bar(have as f64 / records.len() as f64))
                    span.count { (have) " of " (records.len()) }
                    @if let Some((message, count)) = commonest(records, &task.id) {
                        span.soft { (count) " \u{d7} " (message) }
                    }
                }
            }
        }
    }
}

/// Returns the number of records with a right answer to a task.
fn having(records: &[Record], id: &str) -> usize {
    let tasks = records.iter().flat_map(|record| &record.tasks);
    tasks.filter(|task| task.id == id && task.passed).count()
}

/// Returns the most frequent message about a task, and the number of times it occurs. `None` if no
/// message occurs twice.
///
/// Numbers in a message come from each submission's own inputs, so they are ignored.
fn commonest(records: &[Record], id: &str) -> Option<(String, usize)> {
    let mut messages: BTreeMap<Vec<&str>, (String, usize)> = BTreeMap::new();
    let tasks = records.iter().flat_map(|record| &record.tasks);
    for task in tasks.filter(|task| task.id == id && !task.message.is_empty()) {
        let words = task.message.split_whitespace();
        let kind = words.filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect();
        messages.entry(kind).or_insert_with(|| (line(&cut(&task.message, SHOWN)), 0)).1 += 1;
    }
    messages.into_values().max_by_key(|(_, count)| *count).filter(|(_, count)| *count > 1)
}

/// Draws a share, from 0 to 1, as a bar.
pub(crate) fn bar(share: f64) -> Markup {
    html! { span.bar { i style=(format!("width:{:.0}%", 100.0 * share)) {} } }
}

#[cfg(test)]
mod tests {
    use super::commonest;
    use crate::record::Record;

    #[test]
    fn messages_that_differ_in_numbers_are_one() {
        let messages =
            ["at 3, value is -1.5e-3", "at 4, value is 7", "it panics", ""].map(|message| {
                let mut record = Record::sample();
                record.tasks[1].message = message.into();
                record
            });
        assert_eq!(commonest(&messages, "1.2"), Some(("at 3, value is -1.5e-3".into(), 2)));
        assert_eq!(commonest(&messages[1..], "1.2"), None, "nothing was said twice");
    }
}
