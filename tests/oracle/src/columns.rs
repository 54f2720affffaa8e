//! A table with a column for each thread or rank and a row for each moment, as the book shows it.

use std::fmt::{self, Display, Formatter};

/// States or actions of threads or ranks, side by side.
///
/// The book steps through such a table row by row. A cell is a text, or a list of particles'
/// numbers ([`spaced`]). In such a list, a bar separates the parts of a buffer, and the numbers of
/// ghosts are in parentheses. If the numbers of a row are of a different kind, the row's name
/// contains the word *count* or *displacements*.
pub struct Columns {
    heads: Vec<String>,
    rows: Vec<(String, Vec<String>)>,
}

impl Columns {
    /// Returns a table without rows.
    pub fn new(heads: impl IntoIterator<Item = String>) -> Self {
        Self { heads: heads.into_iter().collect(), rows: Vec::new() }
    }

    /// Adds a row. An empty text leaves a column empty.
    pub fn row(&mut self, name: impl Into<String>, cells: impl IntoIterator<Item = String>) {
        self.rows.push((name.into(), cells.into_iter().collect()));
    }
}

impl Display for Columns {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let names = self.rows.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let width = |(column, head): (usize, &String)| {
            let cells = self.rows.iter().filter_map(|(_, cells)| cells.get(column));
            cells.map(String::len).fold(head.len(), usize::max)
        };
        let widths: Vec<usize> = self.heads.iter().enumerate().map(width).collect();
        let lines = self.rows.iter().map(|(name, cells)| (&name[..], cells));
        for (name, cells) in [("", &self.heads)].into_iter().chain(lines) {
            let mut line = format!("{name:names$}");
            for (cell, width) in cells.iter().zip(&widths) {
                line += &format!("  {cell:<width$}");
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

/// Formats numbers separated by spaces, `-` if there are none.
pub fn spaced<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    if items.is_empty() { "-".into() } else { items.join(" ") }
}
