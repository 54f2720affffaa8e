//! Questions about sorted cells and windows of time: tasks 7.13 and 7.14.

use std::f64::consts::PI;

use hard_discs::{Entry, Square, Survey, expected_work};
use lab7::{choose_windows, partners};
use oracle::{Ask, Random, integers, within};

use super::words::short;

/// Draws entries, sorted by cell, in rows of `columns` columns.
fn entries(random: &mut Random, case: usize, columns: usize) -> Vec<Entry> {
    let rows = [1_usize, 4, 70_000, 1 << 20][case % 4];
    let n = random.size(400.min(2 + 8 * case)) as u32 + 1;
    let mut entries = Vec::new();
    for disc in 0..n {
        let row = rows - 1 - random.below(rows.min(3));
        let column = if case.is_multiple_of(3) { columns / 2 } else { random.below(columns) };
        let further = random.size((columns - 1 - column).min(70_000)) as u32;
        entries.push(Entry::new((row * columns + column) as u64, further, disc, true));
    }
    entries.sort_by_key(|entry| entry.cell);
    entries
}

/// Asks for the pairs of few and many boxes in few and many cells, narrow and wide.
pub(crate) fn columns(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..60 {
        let columns = [3_usize, 20, 300, 70_000, 1 << 31][case % 5];
        let entries = entries(random, case, columns);
        for (k, entry) in entries.iter().enumerate() {
            let behind = &entries[k + 1..];
            let next: Vec<u64> = behind.iter().take(6).map(|entry| entry.cell).collect();
            let question = format!(
                "{} entries in rows of {columns} columns. Entry {k} begins in cell {} and covers {} more, and the \
                 entries after it begin in the cells {next:?}: (1) first later entry that shares a column with entry \
                 {k}, (2) entry after the last one that shares a column with it",
                entries.len(),
                entry.cell,
                entry.further
            );
            let found = || {
                let partners = partners(&entries, k);
                integers([partners.start, partners.end])
            };
            ask.exact(&question, found, || {
                let last = entry.cell + u64::from(entry.further);
                let shared = behind.iter().take_while(|entry| entry.cell <= last).count();
                integers([k + 1, k + 1 + shared])
            });
        }
    }
}

/// Asks about cells whose numbers differ by 2³², and a cell with the greatest 32-bit number.
pub(crate) fn far_columns(_: &mut Random, ask: &mut impl Ask) {
    let far = 1 << 32;
    for (cells, further) in [([5, far + 5], 0), ([far - 1, far], 1), ([far - 1, far + 1], 1)] {
        let entries = cells.map(|cell| Entry::new(cell, further, 0, true));
        let question = format!(
            "two entries that begin in cells {cells:?}, and each cover {further} more: (1) first later entry that \
             shares a column with entry 0, (2) entry after the last one that shares a column with it"
        );
        let found = || {
            let partners = partners(&entries, 0);
            integers([partners.start, partners.end])
        };
        ask.exact(&question, found, || {
            let is_shared = cells[1] <= cells[0] + u64::from(further);
            integers([1, 1 + usize::from(is_shared)])
        });
    }
}

/// Asks about many narrow boxes. A program that compares each box with all the boxes after it does
/// not finish.
pub(crate) fn many_columns(_: &mut Random, ask: &mut impl Ask) {
    let question = "a million boxes. Each box begins one column after the previous box, and the widths are 1, 2 and 3 \
                    columns in turn: number of pairs that share a column";
    let found = || {
        within("7.13", 60, || {
            let entries: Vec<Entry> =
                (0..1_000_000).map(|k: u32| Entry::new(u64::from(k), k % 3, k, true)).collect();
            integers([(0..entries.len()).map(|k| partners(&entries, k).len()).sum()])
        })
    };
    ask.exact(question, found, || integers([999_998]));
}

/// A survey of discs for planning a step: slow or fast, sparse or dense, with or without crowds.
#[derive(Clone, Copy)]
struct Plan {
    survey: Survey,
    square: Square,
    crowding: f64,
}

impl Plan {
    /// Draws a survey. Plain cases are asked first.
    fn drawn(random: &mut Random, is_plain: bool) -> Self {
        let most = if is_plain { 0.09 } else { 0.9 };
        let radius = short(is_plain, random.magnitude(1e-9, 1e9));
        let n = short(is_plain, (1 + random.below(1_000_000)) as f64) as usize;
        let wide = (n as f64 * PI / random.magnitude(1e-9, most)).sqrt();
        let side = short(is_plain, radius * wide);
        let [vx, vy] = [(); 2].map(|()| radius * short(is_plain, random.magnitude(1e-3, 1e6)));
        let everywhere = (radius, side - radius);
        let meetings = short(is_plain, random.magnitude(1e-6, 1e3));
        let fastest = 2.0 * vx.max(vy);
        let survey = Survey { n, speed: (vx, vy), fastest, x: everywhere, y: everywhere, meetings };
        let crowding = short(is_plain, random.magnitude(1e-3, 1e12));
        Self { survey, square: Square { side, radius }, crowding }
    }

    /// Returns the cost of a step in `windows` windows.
    fn cost(&self, windows: usize) -> f64 {
        const ENTRY: f64 = 60.0;
        const ASK: f64 = 10.0;
        let work = expected_work(&self.survey, self.square, windows);
        ENTRY * work.entries + self.crowding * (work.pairs + ASK * work.asked)
    }

    /// Returns an error if another number of windows costs less.
    fn is_cheapest(&self, found: &[f64]) -> Result<(), String> {
        let counts: Vec<usize> = (0..=12).map(|k| 1 << k).collect();
        let &[found] = found else { return Err("the answer has no number".into()) };
        let Some(&found) = counts.iter().find(|&&count| count as f64 == found) else {
            return Err(format!("{found} is not a power of two from 1 to 4096"));
        };
        let cost = self.cost(found);
        let cheaper = counts.into_iter().find(|&count| self.cost(count) < cost * (1.0 - 1e-12));
        match cheaper {
            Some(other) => Err(format!(
                "{found} windows cost {cost:e}, but {other} windows cost only {:e}",
                self.cost(other)
            )),
            None => Ok(()),
        }
    }
}

/// Asks for the plans of slow and fast scenes; the planned number of windows must be the cheapest.
pub(crate) fn plans(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..3000 {
        let plan = Plan::drawn(random, case < 60);
        let Plan { survey, square, crowding } = plan;
        let question = format!(
            "{survey:?}, a square of side {:?}, radius {:?}, {crowding:?} times as many pairs as expected: number of \
             windows",
            square.side, square.radius
        );
        let found = || integers([choose_windows(&survey, square, crowding)]);
        ask.judge(&question, found, |found| plan.is_cheapest(found));
    }
}
