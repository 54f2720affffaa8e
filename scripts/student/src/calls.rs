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
    let text = |rank| fs::read_to_string(folder.join(format!("{rank}.txt"))).unwrap_or_default();
    let calls: Vec<Vec<Call>> =
        (0..ranks).map(|rank| text(rank).lines().filter_map(Call::read).collect()).collect();
    let count: usize = calls.iter().map(Vec::len).sum();
    if count == 0 {
        return None;
    }
    let rows = rows(&calls);
    let mut table = Table::new(
        std::iter::once(String::new()).chain((0..ranks).map(|rank| format!("rank {rank}"))),
    );
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
}

/// Returns a row for each collective call, and between these rows the calls of single ranks.
fn rows(calls: &[Vec<Call>]) -> Vec<Vec<String>> {
    let messages = messages(calls);
    let cell = |rank: usize, at: usize| -> String {
        let Call { name, other, location, .. } = &calls[rank][at];
        let which = messages.get(&(rank, at)).map_or(String::new(), |k| format!(" #{k}"));
        let whom = match &calls[rank][at] {
            call if call.sends() => format!("→{other}"),
            call if call.receives() && *other >= 0 => format!("←{other}"),
            _ => String::new(),
        };
        let times = alike(&calls[rank], at);
        let times = if times > 1 { format!(" ×{times}") } else { String::new() };
        format!("{name}{whom}{which}{times} {location}")
    };
    let mut at = vec![0; calls.len()];
    let mut rows = Vec::new();
    loop {
        let next = |rank: usize, at: &[usize]| calls[rank].get(at[rank]);
        let all = 0..calls.len();
        let alone: Vec<bool> =
            all.clone().map(|rank| next(rank, &at).is_some_and(|call| call.number == 0)).collect();
        let together = all.clone().filter_map(|rank| next(rank, &at)).map(|call| call.number).min();
        let Some(together) = together else { return rows };
        let mut row = vec![if together > 0 { together.to_string() } else { String::new() }];
        for rank in all {
            let is_next = next(rank, &at).is_some_and(|call| call.number == together);
            if is_next || alone[rank] {
                row.push(cell(rank, at[rank]));
                at[rank] += alike(&calls[rank], at[rank]);
            } else {
                row.push(String::new());
            }
        }
        rows.push(row);
    }
}

/// Counts equal calls in a row, from this call on, if they involve no other rank, such as waiting.
fn alike(calls: &[Call], at: usize) -> usize {
    let first = &calls[at];
    let alone = first.number == 0 && !first.sends() && !first.receives();
    let same =
        |call: &&Call| alone && (&call.name, &call.location) == (&first.name, &first.location);
    calls[at..].iter().take_while(same).count().max(1)
}

/// Returns the message number of each call that sends or receives a message, by rank and call.
///
/// Messages between two ranks arrive in the order of sending. A receiver's tag must equal the
/// sender's; a negative tag accepts any.
fn messages(calls: &[Vec<Call>]) -> BTreeMap<(usize, usize), usize> {
    let all = |is: fn(&Call) -> bool| {
        let of =
            |rank: usize| calls[rank].iter().enumerate().map(move |(at, call)| (rank, at, call));
        let mut all: Vec<_> =
            (0..calls.len()).flat_map(of).filter(|(_, _, call)| is(call)).collect();
        all.sort_by_key(|(rank, at, _)| (*at, *rank));
        all
    };
    let mut receives = all(Call::receives);
    let mut numbers = BTreeMap::new();
    let mut last = 0;
    for (rank, at, sent) in all(Call::sends) {
        let belongs = |(to, _, call): &(usize, usize, &Call)| {
            let tag = call.tag < 0 || call.tag == sent.tag;
            tag && (call.other, sent.other) == (rank as i64, *to as i64)
        };
        if let Some(found) = receives.iter().position(belongs) {
            let (to, there, _) = receives.remove(found);
            last += 1;
            numbers.extend([((rank, at), last), ((to, there), last)]);
        }
    }
    numbers
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::table;

    #[test]
    fn calls_that_belong_together_stand_in_a_row() {
        let folder = tempfile::tempdir().unwrap();
        let write = |rank: usize, text: &str| {
            fs::write(folder.path().join(format!("{rank}.txt")), text).unwrap();
        };
        assert_eq!(table(folder.path(), 2), None);
        write(
            0,
            "1\tMPI_Gather\t-1\t-1\tlabs/lab5/src/root.rs, line 29\n\
             0\tMPI_Isend\t1\t7\tlabs/lab6/src/exchange.rs, line 3\n\
             0\tMPI_Isend\t1\t7\tlabs/lab6/src/exchange.rs, line 4\n\
             0\tMPI_Wait\t-1\t-1\tlabs/lab6/src/exchange.rs, line 6\n\
             0\tMPI_Wait\t-1\t-1\tlabs/lab6/src/exchange.rs, line 6\n\
             2\tMPI_Barrier\t-1\t-1\tlabs/lab6/src/exchange.rs, line 9\n",
        );
        write(
            1,
            "1\tMPI_Gather\t-1\t-1\tlabs/lab5/src/root.rs, line 31\n\
             0\tMPI_Recv\t0\t7\tlabs/lab6/src/exchange.rs, line 5\n\
             2\tMPI_Barrier\t-1\t-1\tlabs/lab6/src/exchange.rs, line 9\n",
        );
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
