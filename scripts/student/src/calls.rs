//! Table of the MPI calls of a run, with a column for each rank. Related calls share a row.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use lab_kit::table::Table;

/// Maximal number of rows, which is more than a step or two needs.
const ROWS: usize = 60;

/// Explanation below the table.
const LEGEND: &str = "\
A row with a number is one call, which all ranks make together. Other calls are of
one rank: →1 sends to rank 1, ←1 receives from it, and #4 is the same message on
both. Behind a call stand its file and line.
";

/// A call, as `labs/common-mpi` records it.
struct Call {
    /// Number of a collective call, equal on all ranks; 0 for a call that is not collective.
    number: u64,
    name: String,
    /// The other rank; negative if there is none, or if it is any rank.
    other: i64,
    tag: i64,
    /// File without `.rs`, and line: `root:29`.
    location: String,
}

/// Makes the table of the records in `folder`; `None` if the lab's files made no call on any rank.
pub(crate) fn table(folder: &Path, ranks: usize) -> Option<String> {
    let mut calls: Vec<Vec<Call>> = Vec::new();
    let mut header = vec![String::new()];
    for rank in 0..ranks {
        let text = fs::read_to_string(folder.join(format!("{rank}.txt"))).unwrap_or_default();
        calls.push(text.lines().filter_map(Call::read).collect());
        header.push(format!("rank {rank}"));
    }
    if calls.iter().all(Vec::is_empty) {
        return None;
    }
    let rows = rows(&calls);
    let mut table = Table::new(header);
    rows.iter().take(ROWS).for_each(|row| table.row(row.clone()));
    let more = rows.len().saturating_sub(ROWS);
    let more = if more > 0 { format!("… and {more} more rows\n") } else { String::new() };
    Some(format!("{table}{more}\n{LEGEND}"))
}

impl Call {
    fn read(line: &str) -> Option<Self> {
        let mut parts = line.split('\t');
        let number = parts.next()?.parse().ok()?;
        let name = parts.next()?.trim_start_matches("MPI_").to_owned();
        let other = parts.next()?.parse().ok()?;
        let tag = parts.next()?.parse().ok()?;
        let (path, line) = parts.next()?.split_once(", line ")?;
        let file = path.rsplit('/').next()?.trim_end_matches(".rs");
        Some(Self { number, name, other, tag, location: format!("{file}:{line}") })
    }

    fn sends(&self) -> bool {
        ["Send", "Ssend", "Isend"].contains(&&*self.name)
    }

    fn receives(&self) -> bool {
        ["Recv", "Irecv", "Mprobe"].contains(&&*self.name)
    }

    /// Formats the call for the table, with the number of its message and of its repetitions.
    fn cell(&self, message: Option<&usize>, times: usize) -> String {
        let Self { name, other, location, .. } = self;
        let whom = match self {
            call if call.sends() => format!("→{other}"),
            call if call.receives() && *other >= 0 => format!("←{other}"),
            _ => String::new(),
        };
        let which = message.map_or(String::new(), |number| format!(" #{number}"));
        let times = if times > 1 { format!(" ×{times}") } else { String::new() };
        format!("{name}{whom}{which}{times} {location}")
    }
}

/// Returns a row for each collective call, and between these rows the calls of single ranks.
fn rows(calls: &[Vec<Call>]) -> Vec<Vec<String>> {
    let messages = messages(calls);
    let mut at = vec![0; calls.len()];
    let mut rows = Vec::new();
    loop {
        let next = calls.iter().zip(&at).filter_map(|(calls, &at)| calls.get(at));
        // Calls of single ranks have the number 0, so they precede the next collective call.
        let Some(number) = next.map(|call| call.number).min() else { return rows };
        let mut row = vec![if number > 0 { number.to_string() } else { String::new() }];
        for (rank, at) in at.iter_mut().enumerate() {
            let rest = &calls[rank][*at..];
            match rest.first() {
                Some(call) if call.number == number => {
                    let times = alike(call, rest);
                    row.push(call.cell(messages.get(&(rank, *at)), times));
                    *at += times;
                }
                _ => row.push(String::new()),
            }
        }
        rows.push(row);
    }
}

/// Counts the calls that repeat `first`, with itself, if it involves no other rank, such as
/// waiting.
fn alike(first: &Call, calls: &[Call]) -> usize {
    if first.number > 0 || first.sends() || first.receives() {
        return 1;
    }
    let what = (&first.name, &first.location);
    calls.iter().take_while(|call| (&call.name, &call.location) == what).count()
}

/// Returns the message number of each call that sends or receives a message, by rank and call.
///
/// Messages between two ranks arrive in the order of sending. A receiver's tag must equal the
/// sender's; a negative tag accepts any.
fn messages(calls: &[Vec<Call>]) -> BTreeMap<(usize, usize), usize> {
    let mut receives = in_order(calls, Call::receives);
    let mut numbers = BTreeMap::new();
    let mut last = 0;
    for (rank, at, sent) in in_order(calls, Call::sends) {
        let found = receives.iter().position(|(to, _, call)| {
            let tag = call.tag < 0 || call.tag == sent.tag;
            tag && (call.other, sent.other) == (rank as i64, *to as i64)
        });
        if let Some(found) = found {
            let (to, there, _) = receives.remove(found);
            last += 1;
            numbers.extend([((rank, at), last), ((to, there), last)]);
        }
    }
    numbers
}

/// Returns the wanted calls with their rank and their place in its record, sorted by place.
fn in_order(calls: &[Vec<Call>], wanted: fn(&Call) -> bool) -> Vec<(usize, usize, &Call)> {
    let mut found = Vec::new();
    for (rank, calls) in calls.iter().enumerate() {
        let places = calls.iter().enumerate().filter(|(_, call)| wanted(call));
        found.extend(places.map(|(at, call)| (rank, at, call)));
    }
    found.sort_by_key(|(rank, at, _)| (*at, *rank));
    found
}

#[cfg(test)]
mod tests {
    use super::table;
    use lab_kit::Kit;

    #[test]
    fn calls_that_belong_together_stand_in_a_row() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(table(folder.path(), 2), None);
        let zero = "1\tMPI_Gather\t-1\t-1\tlabs/lab5/src/root.rs, line 29\n\
             0\tMPI_Isend\t1\t7\tlabs/lab6/src/exchange.rs, line 3\n\
             0\tMPI_Isend\t1\t7\tlabs/lab6/src/exchange.rs, line 4\n\
             0\tMPI_Wait\t-1\t-1\tlabs/lab6/src/exchange.rs, line 6\n\
             0\tMPI_Wait\t-1\t-1\tlabs/lab6/src/exchange.rs, line 6\n\
             2\tMPI_Barrier\t-1\t-1\tlabs/lab6/src/exchange.rs, line 9\n";
        let one = "1\tMPI_Gather\t-1\t-1\tlabs/lab5/src/root.rs, line 31\n\
             0\tMPI_Recv\t0\t7\tlabs/lab6/src/exchange.rs, line 5\n\
             2\tMPI_Barrier\t-1\t-1\tlabs/lab6/src/exchange.rs, line 9\n";
        Kit::of_files(folder.path(), &[("0.txt", zero), ("1.txt", one)]);
        let shown = table(folder.path(), 2).unwrap();
        let rows: Vec<Vec<&str>> = shown
            .lines()
            .map(|line| line.split("  ").map(str::trim).filter(|s| !s.is_empty()).collect())
            .collect();
        assert_eq!(rows[1], ["1", "Gather root:29", "Gather root:31"]);
        assert_eq!(rows[2], ["Isend→1 #1 exchange:3", "Recv←0 #1 exchange:5"]);
        assert_eq!(rows[3], ["Isend→1 exchange:4"]);
        assert_eq!(rows[4], ["Wait ×2 exchange:6"]);
        assert_eq!(rows[5], ["2", "Barrier exchange:9", "Barrier exchange:9"]);
    }
}
