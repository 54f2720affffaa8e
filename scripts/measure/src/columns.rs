//! Tables of runs, told by their columns.

use lab_kit::table::{Table, three_digits};

use super::clock::{Ratio, Span, times_longer};

/// The columns of a table: what stands above each, and what it says of a row.
pub struct Columns<'c, R> {
    columns: Vec<(String, Cell<'c, R>)>,
}

/// What a column says of a row; none where it has nothing to say.
type Cell<'c, R> = Box<dyn Fn(&R) -> Option<String> + 'c>;

impl<'c, R> Columns<'c, R> {
    /// A table's first column: what names a row.
    pub fn of(head: impl Into<String>, name: impl Fn(&R) -> String + 'c) -> Self {
        Self { columns: Vec::new() }.text(head, name)
    }

    /// A column of words.
    pub fn text(self, head: impl Into<String>, cell: impl Fn(&R) -> String + 'c) -> Self {
        self.perhaps(head, move |row| Some(cell(row)))
    }

    /// A column that is left out where it has nothing to say of any row.
    pub fn perhaps(
        mut self,
        head: impl Into<String>,
        cell: impl Fn(&R) -> Option<String> + 'c,
    ) -> Self {
        self.columns.push((head.into(), Box::new(cell)));
        self
    }

    /// A column of numbers, left out where there is none.
    pub fn number(self, head: impl Into<String>, value: impl Fn(&R) -> Option<f64> + 'c) -> Self {
        self.perhaps(head, move |row| value(row).map(three_digits))
    }

    /// A column of numbers for each of `heads`, by its index.
    pub fn numbers(
        self,
        heads: impl IntoIterator<Item = impl Into<String>>,
        value: impl Fn(&R, usize) -> Option<f64> + Copy + 'c,
    ) -> Self {
        let add = |columns: Self, (at, head)| columns.number(head, move |row| value(row, at));
        heads.into_iter().enumerate().fold(self, add)
    }

    /// The shortest take and the median.
    pub fn times(self, unit: &str, times: impl Fn(&R) -> Span + Copy + 'c) -> Self {
        self.number(format!("{unit}min"), move |row| Some(times(row).min))
            .number("median", move |row| Some(times(row).median))
    }

    /// How far the times spread, and how they compare with another run's; nothing is decided of that run itself.
    pub fn compared(self, of: impl Fn(&R) -> (f64, Option<Ratio>) + Copy + 'c) -> Self {
        let times = |ratio: Option<f64>| ratio.map_or("1".into(), times_longer);
        let decided = |ratio: Option<Ratio>| ratio.map_or("", |ratio| ratio.in_words());
        self.text("spread", move |row| format!("{:.0} %", 100.0 * of(row).0))
            .text("ratio of min", move |row| times(of(row).1.map(|ratio| ratio.of_minima)))
            .text("of median", move |row| times(of(row).1.map(|ratio| ratio.of_medians)))
            .text("decided", move |row| decided(of(row).1).into())
    }

    /// The table of these rows.
    pub fn table<'r>(&self, rows: impl IntoIterator<Item = &'r R>) -> Table
    where
        R: 'r,
    {
        let rows: Vec<&R> = rows.into_iter().collect();
        let column = |(head, cell): &(String, Cell<'c, R>)| {
            let cells: Vec<_> = rows.iter().map(|row| cell(row)).collect();
            let says = cells.iter().any(Option::is_some);
            says.then(|| (head.clone(), cells))
        };
        let columns: Vec<_> = self.columns.iter().filter_map(column).collect();
        let mut table = Table::new(columns.iter().map(|(head, _)| head.clone()));
        for row in 0..rows.len() {
            table.row(columns.iter().map(|(_, cells)| cells[row].clone().unwrap_or_default()));
        }
        table
    }
}
