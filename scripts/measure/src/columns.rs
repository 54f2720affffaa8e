//! Tables that are described by their columns: each row is a value of the same type.

use lab_kit::table::{Table, three_digits};

use super::clock::{Ratio, Span, times_longer};

/// Columns of a table: the heading of each, and its cell in a row.
pub struct Columns<'c, R> {
    columns: Vec<(String, Cell<'c, R>)>,
}

/// The text of a column in a row; `None` if the cell is empty.
type Cell<'c, R> = Box<dyn Fn(&R) -> Option<String> + 'c>;

impl<'c, R> Columns<'c, R> {
    /// Makes a table that begins with a column of row names.
    pub fn of(head: impl Into<String>, name: impl Fn(&R) -> String + 'c) -> Self {
        Self { columns: Vec::new() }.text(head, name)
    }

    /// Adds a column of texts.
    pub fn text(self, head: impl Into<String>, cell: impl Fn(&R) -> String + 'c) -> Self {
        self.perhaps(head, move |row| Some(cell(row)))
    }

    /// Adds a column that is omitted if it is empty in every row.
    pub fn perhaps(
        mut self,
        head: impl Into<String>,
        cell: impl Fn(&R) -> Option<String> + 'c,
    ) -> Self {
        self.columns.push((head.into(), Box::new(cell)));
        self
    }

    /// Adds a column of numbers that is omitted if no row has a number.
    pub fn number(self, head: impl Into<String>, value: impl Fn(&R) -> Option<f64> + 'c) -> Self {
        self.perhaps(head, move |row| value(row).map(three_digits))
    }

    /// Adds a column of numbers for each of `heads`. `value` is given a row and the index of the
    /// column.
    pub fn numbers(
        mut self,
        heads: impl IntoIterator<Item = impl Into<String>>,
        value: impl Fn(&R, usize) -> Option<f64> + Copy + 'c,
    ) -> Self {
        for (at, head) in heads.into_iter().enumerate() {
            self = self.number(head, move |row| value(row, at));
        }
        self
    }

    /// Adds columns for the shortest take and the median.
    pub fn times(self, unit: &str, times: impl Fn(&R) -> Span + Copy + 'c) -> Self {
        self.number(format!("{unit}min"), move |row| Some(times(row).min))
            .number("median", move |row| Some(times(row).median))
    }

    /// Adds columns for the spread of the times, and for their ratio to another run. The other run
    /// itself has no ratio.
    pub fn compared(
        self,
        spread: impl Fn(&R) -> f64 + 'c,
        ratio: impl Fn(&R) -> Option<Ratio> + Copy + 'c,
    ) -> Self {
        self.text("spread", move |row| format!("{:.0} %", 100.0 * spread(row)))
            .text("ratio of min", move |row| {
                ratio(row).map_or("1".into(), |ratio| times_longer(ratio.of_minima))
            })
            .text("of median", move |row| {
                ratio(row).map_or("1".into(), |ratio| times_longer(ratio.of_medians))
            })
            .text("decided", move |row| match ratio(row) {
                Some(ratio) if ratio.decided => "yes".into(),
                Some(_) => "no: spread".into(),
                None => String::new(),
            })
    }

    /// Makes the table of these rows.
    pub fn table<'r>(&self, rows: impl IntoIterator<Item = &'r R>) -> Table
    where
        R: 'r,
    {
        let rows: Vec<&R> = rows.into_iter().collect();
        let mut heads = Vec::new();
        let mut lines = vec![Vec::new(); rows.len()];
        for (head, cell) in &self.columns {
            let cells: Vec<Option<String>> = rows.iter().map(|row| cell(row)).collect();
            if cells.iter().all(Option::is_none) {
                continue;
            }
            heads.push(head.clone());
            for (line, cell) in lines.iter_mut().zip(cells) {
                line.push(cell.unwrap_or_default());
            }
        }
        let mut table = Table::new(heads);
        lines.into_iter().for_each(|line| table.row(line));
        table
    }
}
