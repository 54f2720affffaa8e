//! Questions about the rows that a worker owns.

use lab3::own_rows;
use oracle::{Ask, Random, integers};

/// Asks for the owners of few and many rows among few and many workers, and of the greatest numbers
/// of rows.
pub(crate) fn owners(random: &mut Random, ask: &mut impl Ask) {
    let few = (1..=64).flat_map(|workers| {
        [1, workers - 1, 61, 5 * workers, 9 * workers].map(|rows| (rows, workers))
    });
    let mut cases: Vec<(usize, usize)> = few.collect();
    for case in 0..120 {
        let most = [40, 300, 70_000][if case % 12 == 11 { 2 } else { case % 2 }];
        let rows = if most == 300 { random.below(1 << 40) } else { random.size(most) };
        cases.push((rows, 1 + random.size(most)));
    }
    for (rows, workers) in cases {
        let question = format!(
            "{rows} rows, {workers} workers: for each worker, its first row and the row after its last row"
        );
        let found = || {
            let each = (0..workers).map(|worker| own_rows(worker, workers, rows));
            integers(each.flat_map(|own| [own.start, own.end]))
        };
        ask.judge(&question, found, |found| are_shared_out(rows, found));
    }
}

/// Checks that the ranges of rows are consecutive, cover all rows and are shared out evenly.
fn are_shared_out(rows: usize, found: &[f64]) -> Result<(), String> {
    let (each, _) = found.as_chunks::<2>();
    let mut next = 0.0;
    for (worker, [start, end]) in each.iter().enumerate() {
        if *start != next {
            return Err(format!(
                "worker {worker} begins with row {start}, but must begin with row {next}"
            ));
        }
        if end < start {
            return Err(format!(
                "worker {worker} begins with row {start}, but ends before row {end}"
            ));
        }
        next = *end;
    }
    if next != rows as f64 {
        return Err(format!(
            "the last worker ends before row {next}, but must end before row {rows}"
        ));
    }
    let sizes = || each.iter().map(|[start, end]| end - start);
    let least = sizes().fold(f64::INFINITY, f64::min);
    let most = sizes().fold(0.0, f64::max);
    if most - least > 1.0 {
        return Err(format!(
            "one worker has {most} rows, and another worker has {least}, but their numbers of rows may differ by at \
             most one"
        ));
    }
    Ok(())
}
