//! Aligned tables on the terminal.

use std::fmt;

/// A table: a header, then rows of as many cells.
#[derive(Clone, Debug)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// An empty table.
    pub fn new<S: Into<String>>(header: impl IntoIterator<Item = S>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Adds a row; missing cells stay empty.
    pub fn row<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}

/// The first column, the names, to the left; the others, the numbers, to the right.
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = || std::iter::once(&self.header).chain(&self.rows);
        let cell = |line: &Vec<String>, at: usize| line.get(at).cloned().unwrap_or_default();
        let columns = lines().map(Vec::len).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns)
            .map(|at| lines().map(|line| cell(line, at).chars().count()).max().unwrap_or(0))
            .collect();
        for line in lines() {
            let cells = widths.iter().enumerate().map(|(at, &width)| match at {
                0 => format!("{:width$}", cell(line, at)),
                _ => format!("  {:>width$}", cell(line, at)),
            });
            writeln!(f, "{}", cells.collect::<String>().trim_end())?;
        }
        Ok(())
    }
}

/// A number with three significant digits, as tables show times and ratios.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let mut table = Table::new(["variant", "µs"]);
        table.row(["sorted", "1.5"]);
        table.row(["linked-list", "12.25"]);
        table.row(["none"]);
        let lines = ["variant         µs", "sorted         1.5", "linked-list  12.25", "none", ""];
        assert_eq!(table.to_string(), lines.join("\n"));
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
