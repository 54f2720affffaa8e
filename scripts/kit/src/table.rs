//! Aligned tables on the terminal.

use std::fmt;

use crate::terminal::{columns, fold};

/// A table: a header, and rows with the same number of cells.
#[derive(Clone, Debug)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Makes an empty table.
    pub fn new<S: Into<String>>(header: impl IntoIterator<Item = S>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Adds a row. Missing cells stay empty.
    pub fn row<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}

/// Aligns the first column (names) to the left and the others (numbers) to the right.
///
/// A heading that is wider than its cells is folded. Columns beyond the width of the terminal go
/// into a second table below.
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.within(f, columns())
    }
}

impl Table {
    fn within(&self, f: &mut impl fmt::Write, page: usize) -> fmt::Result {
        let mut widths = Vec::new();
        for (at, head) in self.header.iter().enumerate() {
            let cells = self.rows.iter().filter_map(|row| row.get(at)).map(|cell| width(cell));
            widths.push(cells.chain(head.split(' ').map(width)).max().unwrap_or(0));
        }
        let mut columns = 1..self.header.len();
        loop {
            let mut room = page.saturating_sub(widths.first().copied().unwrap_or(0));
            let fitting = columns.clone().take_while(|&at| {
                let fits = room >= widths[at] + 2;
                room = room.saturating_sub(widths[at] + 2);
                fits
            });
            let count = fitting.count().max(1).min(columns.len());
            let shown: Vec<usize> =
                std::iter::once(0).chain(columns.by_ref().take(count)).collect();
            self.lines(f, &shown, &widths)?;
            if columns.is_empty() {
                return Ok(());
            }
            writeln!(f)?;
        }
    }

    fn lines(&self, f: &mut impl fmt::Write, shown: &[usize], widths: &[usize]) -> fmt::Result {
        let folded = self.header.iter().zip(widths).map(|(head, width)| fold("", head, *width));
        let heads: Vec<String> = folded.collect();
        let high = shown.iter().filter_map(|&at| heads.get(at)).map(|head| head.lines().count());
        // Short headings are at the bottom, next to the rows. So lines are counted from the bottom.
        for line in (0..high.max().unwrap_or(0)).rev() {
            line_of(f, shown, widths, |at| heads[at].lines().rev().nth(line))?;
        }
        for row in &self.rows {
            line_of(f, shown, widths, |at| row.get(at).map(String::as_str))?;
        }
        Ok(())
    }
}

/// Writes the cells of a line, each by the number of its column.
fn line_of<'c>(
    f: &mut impl fmt::Write,
    shown: &[usize],
    widths: &[usize],
    cell: impl Fn(usize) -> Option<&'c str>,
) -> fmt::Result {
    let mut line = String::new();
    for &at in shown {
        let cell = cell(at).unwrap_or_default();
        let width = widths[at];
        line += &if at == 0 { format!("{cell:width$}") } else { format!("  {cell:>width$}") };
    }
    writeln!(f, "{}", line.trim_end())
}

fn width(text: &str) -> usize {
    text.chars().count()
}

/// Formats a number with three significant digits, as tables show times and ratios.
pub fn three_digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let exponent = format!("{value:.2e}").split_once('e').and_then(|(_, e)| e.parse().ok());
    match exponent.unwrap_or(0) {
        exponent @ -4..=2 => format!("{value:.*}", (2 - exponent) as usize),
        3..=8 => format!("{value:.0}"),
        _ => format!("{value:.2e}"),
    }
}

/// Separates thousands by commas: `1234567.8` becomes `1,234,567.8`.
pub fn with_commas(text: &str) -> String {
    let point = text.find('.').unwrap_or(text.len());
    let mut out = text.to_owned();
    let mut at = point;
    while at > 3 && text[..at - 3].ends_with(|c: char| c.is_ascii_digit()) {
        at -= 3;
        out.insert(at, ',');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terminal::WIDTH;

    #[test]
    fn columns_line_up() {
        let mut table = Table::new(["variant", "µs"]);
        table.row(["sorted", "1.5"]);
        table.row(["linked-list", "12.25"]);
        table.row(["none"]);
        let lines = ["variant         µs", "sorted         1.5", "linked-list  12.25", "none", ""];
        assert_eq!(shown(&table, WIDTH), lines.join("\n"));
    }

    fn shown(table: &Table, page: usize) -> String {
        let mut text = String::new();
        table.within(&mut text, page).unwrap();
        text
    }

    #[test]
    fn wide_headings_and_many_columns_find_room() {
        let mut table = Table::new(["name", "ms a step: min", &"x".repeat(70)]);
        table.row(["sorted", "1.5", "2"]);
        let below = format!("name    {}\nsorted  {:>70}\n", "x".repeat(70), 2);
        let text = format!("         ms a\n        step:\nname      min\nsorted    1.5\n\n{below}");
        assert_eq!(shown(&table, WIDTH), text);
        assert_eq!(shown(&table, 12), text, "one column at least");
        let widest = shown(&table, 200).lines().map(width).max();
        assert_eq!(widest, Some("sorted".len() + 2 + "step:".len() + 2 + 70));
    }

    #[test]
    fn three_digits_are_three_digits() {
        for (value, text) in [
            (0.0, "0"),
            (12.345, "12.3"),
            (0.099_96, "0.100"),
            (999.6, "1000"),
            (123_456.0, "123456"),
            (0.000_001_234, "1.23e-6"),
            (1.0, "1.00"),
        ] {
            assert_eq!(three_digits(value), text);
        }
    }
}
