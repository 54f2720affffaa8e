//! The table of a worked example.

use std::fmt::{self, Display, Formatter};

use crate::columns::spaced;

/// A table with a heading for each column: the input of an example, and the lab's results. Columns
/// of numbers are right-aligned.
pub struct Table(Vec<Vec<String>>);

impl Table {
    /// Returns a table without rows.
    pub fn new<const N: usize>(headings: [&str; N]) -> Self {
        Self(vec![headings.map(String::from).to_vec()])
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [&dyn Display; N]) {
        self.0.push(cells.map(ToString::to_string).to_vec());
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let columns = self.0.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = self.0.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for row in &self.0 {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let width = widths[column];
                line += &match self.is_of_numbers(column) {
                    true => format!("{cell:>width$}  "),
                    false => format!("{cell:<width$}  "),
                };
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

impl Table {
    /// Returns whether every cell of a column is a number, or a mark for a missing number.
    fn is_of_numbers(&self, column: usize) -> bool {
        let mut cells = self.0.iter().skip(1).filter_map(|row| row.get(column));
        cells.all(|cell| cell.parse::<f64>().is_ok() || ["none", "-"].contains(&&cell[..]))
    }
}

/// Formats numbers in ascending order, separated by spaces; `-` if there are none. Use this
/// function for lists in which the order does not matter.
pub fn ascending<T: Display + Ord>(items: impl IntoIterator<Item = T>) -> String {
    let mut items: Vec<T> = items.into_iter().collect();
    items.sort_unstable();
    spaced(items)
}

#[cfg(test)]
mod tests {
    use super::{Table, ascending};

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let mut table = Table::new(["particle", "x", "where"]);
        table.row([&0, &"0.25", &"inside"]);
        table.row([&12, &-1.5, &"outside"]);
        let lines = ["particle     x  where", "       0  0.25  inside", "      12  -1.5  outside"];
        assert_eq!(table.to_string().lines().collect::<Vec<_>>(), lines);
        assert_eq!(ascending([3, 1, 2]), "1 2 3");
        assert_eq!(ascending::<u8>([]), "-");
    }
}
