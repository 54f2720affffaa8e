//! The contents of the buffers of a job's ranks, side by side.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use crate::Columns;

/// Beginning of each line of a rank's column, on the rank's standard output.
const MARK: &str = "|column|";

/// Prints the column of `rank` for [`join_columns`]: the name and the contents of each row.
///
/// Each rank must call this function exactly once, and all ranks must pass the same row names in
/// the same order. The text of a row without contents is empty.
pub fn print_column(rank: i32, rows: &[(&str, String)]) {
    let mut lines = String::from("\n");
    for (row, (name, cell)) in rows.iter().enumerate() {
        let _ = writeln!(lines, "{MARK}{row}|{rank}|{name}|{cell}");
    }
    // All lines are printed in one piece, because all ranks print at the same time.
    print!("{lines}");
}

/// Returns the table of all columns that ranks printed to `stdout`.
pub fn join_columns(stdout: &str) -> String {
    let mut rows: BTreeMap<usize, (&str, BTreeMap<usize, &str>)> = BTreeMap::new();
    for line in stdout.lines().filter_map(|line| line.strip_prefix(MARK)) {
        let fields: Vec<&str> = line.splitn(4, '|').collect();
        let [row, rank, name, cell] = fields[..] else { continue };
        let (Ok(row), Ok(rank)) = (row.parse(), rank.parse()) else { continue };
        rows.entry(row).or_insert((name, BTreeMap::new())).1.insert(rank, cell);
    }
    let ranks: BTreeSet<usize> =
        rows.values().flat_map(|(_, cells)| cells.keys().copied()).collect();
    let mut table = Columns::new(ranks.iter().map(|rank| format!("rank {rank}")));
    for (name, cells) in rows.values() {
        table.row(*name, ranks.iter().map(|rank| cells.get(rank).unwrap_or(&"").to_string()));
    }
    table.to_string()
}
