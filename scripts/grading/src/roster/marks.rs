//! Writes a roster in the format of its platform: the same columns, with marks.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use csv::{StringRecord, Writer};

use super::students::{Form, Roster, column};
use crate::record::points;

/// Name of the row in Canvas's file that contains the possible points.
const POSSIBLE: &str = "Points Possible";

impl Roster {
    /// Returns the file with marks added. `shares` contains each row's share of all points, 0 to 1.
    ///
    /// Marks are scaled to the possible points of the file, or to `full` points if the file does
    /// not contain them.
    pub(super) fn with_marks(
        &self,
        name: &str,
        full: f64,
        shares: &BTreeMap<usize, f64>,
    ) -> Result<String> {
        let known = self.marks_column(name);
        let at = known.unwrap_or(self.header.len());
        let mut table: Vec<Vec<String>> = [&self.header]
            .into_iter()
            .chain(self.rows.iter().map(|(_, row)| row))
            .map(|row| row.iter().map(String::from).collect())
            .collect();
        if known.is_none() {
            table.iter_mut().for_each(|row| row.push(String::new()));
            table[0][at] = name.to_owned();
        }
        for (row, (line, cells)) in self.rows.iter().enumerate() {
            if self.is_possible(cells) && table[row + 1][at].is_empty() {
                table[row + 1][at] = points(full);
            }
            if let Some(share) = shares.get(&row) {
                let most = self.most(at, *line, cells)?.unwrap_or(full);
                table[row + 1][at] = points(share * most);
            }
        }
        let mut out = Writer::from_writer(Vec::new());
        for row in table {
            out.write_record(row)?;
        }
        Ok(String::from_utf8(out.into_inner()?)?)
    }

    /// Returns the column of the marks; `None` if the file has no such column yet.
    fn marks_column(&self, name: &str) -> Option<usize> {
        let numbered = format!("{name} (");
        let assignment = format!("Assignment: {name} (");
        match self.form {
            Form::Worksheet => column(&self.header, "Grade"),
            _ => self.header.iter().position(|header| {
                header == name
                    || [&numbered, &assignment].iter().any(|own| header.starts_with(*own))
            }),
        }
    }

    /// Returns the possible points in the file; `None` if it does not contain them.
    fn most(&self, at: usize, line: u64, cells: &StringRecord) -> Result<Option<f64>> {
        let (text, line) = match self.form {
            Form::Gradebook | Form::Gradescope | Form::Classroom => return Ok(None),
            Form::Worksheet => (column(&self.header, "Maximum Grade").map(|at| &cells[at]), line),
            Form::Canvas => {
                let row = self.rows.iter().find(|(_, row)| self.is_possible(row));
                (row.and_then(|(_, row)| row.get(at)), row.map_or(1, |(line, _)| *line))
            }
        };
        let Some(text) = text.map(str::trim).filter(|text| !text.is_empty()) else {
            return Ok(None);
        };
        let most = text.replace(',', ".").parse().ok().filter(|most: &f64| most.is_finite());
        most.map(Some).with_context(|| {
            format!("{}, line {line}: '{text}' is no number of points", self.path.display())
        })
    }

    fn is_possible(&self, cells: &StringRecord) -> bool {
        self.form == Form::Canvas && cells.iter().any(|cell| cell.trim() == POSSIBLE)
    }
}
