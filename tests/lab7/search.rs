//! What tests and probe ask alike about loops that are shared out, and about where discs can meet.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering::Relaxed;
use std::thread;
use std::time::{Duration, Instant};

use hard_discs::{
    Entry, Schedule, SharedCount, Span, Square, Survey, Team, Window, Workers, expected_work,
};
use lab7::{
    block_of, blocks_around, choose_windows, fixed_part, inner, look_around, nested, next_part,
    outer, partners, span,
};

use super::Share;
use super::ask::{Ask, beside, rounded, whole};
use super::questions::short;
use crate::Random;

/// Loops of any length, also beyond 32 bits, in fixed parts.
pub(super) fn parts(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(70_000).into_iter().chain([49, 61, 1 << 31, (1 << 32) + 7, 1 << 40]) {
        for workers in [1, 2, 3, 7, 8, 9, 33, 49, 256, 257, 1 + random.below(300)] {
            let parts: Vec<_> = (0..workers).map(|worker| fixed_part(n, workers, worker)).collect();
            let name = format!("{n} iterations in fixed parts for {workers} workers");
            let wrong = (1..workers).find(|&k| parts[k].start != parts[k - 1].end);
            let question = format!(
                "{name}: where the first begins, where the last ends, and the part, if there is one, that does not begin where the \
                 one before it ends"
            );
            let found = [Some(parts[0].start), Some(parts[workers - 1].end), wrong];
            ask(&question, whole(found.into_iter().flatten()), whole([0, n]));
            let lengths = parts.iter().map(ExactSizeIterator::len);
            let uneven = lengths.clone().max().unwrap_or(0) - lengths.min().unwrap_or(0);
            ask(
                &format!(
                    "{name}: how many iterations the longest has more than the shortest, 1 for none"
                ),
                whole([uneven.max(1)]),
                whole([1]),
            );
        }
    }
}

/// The parts that the queue hands out, and what it says when there are none left.
pub(super) fn queues(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(70_000) {
        for chunk in [1, 2, 7, n.max(1), n + 1, 1 + random.below(n + 1)] {
            let next = SharedCount::default();
            let mut found = Vec::new();
            while let Some(part) = next_part(&next, n, chunk) {
                found.extend([part.start, part.end]);
                if found.len() > 2 * n + 8 {
                    break;
                }
            }
            let after = usize::from(next_part(&next, n, chunk).is_some());
            let right: Vec<usize> =
                (0..n).step_by(chunk).flat_map(|start| [start, n.min(start + chunk)]).collect();
            let name = format!("{n} iterations from the queue in chunks of {chunk}");
            ask(&format!("{name}: begin and end of each part"), whole(found), whole(right));
            ask(&format!("{name}: is there another after the end?"), whole([after]), whole([0]));
        }
    }
}

type Loop = fn(usize, Team, Schedule, &(dyn Fn(usize, usize, Range<usize>) + Sync));

/// Which loop is shared out, and how.
const SHARES: [(&str, Loop); 3] = [
    ("the outer loop", |n, team, schedule, look| outer(n, team, schedule, look)),
    ("the inner loop", |n, team, schedule, look| inner(n, team, schedule, look)),
    ("both loops", |n, team, schedule, look| nested(n, team, schedule, look)),
];

/// Which list each pair comes into in fixed parts. What parts they are is another task: the lab's own.
pub(super) fn loops(random: &mut Random, ask: Ask<'_>) {
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        // A sandbox has not room for 17 teams of 17 threads.
        let most = [17, 17, 9][which];
        for (n, workers) in
            random.sizes(33).into_iter().flat_map(|n| [1, 2, 3, 8, most].map(|w| (n, w)))
        {
            let looks = Mutex::new(Vec::new());
            share(n, Team::Fresh(workers), Schedule::Static, &|list, a, partners: Range<usize>| {
                let pairs = partners.take(100).map(|b| [a, b, list]);
                looks.lock().expect("no thread panics here").extend(pairs);
            });
            let mut found = looks.into_inner().expect("as above");
            found.sort_unstable();
            let owner = |n: usize, k: usize| {
                (0..workers)
                    .find(|&worker| fixed_part(n, workers, worker).contains(&k))
                    .unwrap_or(0)
            };
            let mut right = Vec::new();
            for a in 0..n {
                for b in a + 1..n {
                    let (row, column) = (owner(n, a), owner(n - a - 1, b - a - 1));
                    right.push([a, b, [row, column, row * workers + column][which]]);
                }
            }
            let question =
                format!("{name} of {n} discs, {workers} workers: disc, partner, list of each pair");
            ask(&question, whole(found.concat()), whole(right.concat()));
        }
    }
}

/// All pairs once from a queue, also while the worker that has disc 0 is held up.
pub(super) fn queued_loops(random: &mut Random, ask: Ask<'_>) {
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        for n in random.sizes(33) {
            let (workers, chunk) = (1 + random.below(4), 1 + random.below(5));
            let (looks, queue) = (Mutex::new(Vec::new()), Schedule::Dynamic { chunk });
            share(n, Team::Fresh(workers), queue, &|_, a, partners: Range<usize>| {
                // In how many parts the worker of a row looks at it is its own affair.
                let step = if which == 0 { 1 } else { partners.len().max(1) };
                let parts = partners.clone().step_by(step).map(|b| [a, b, b + step]);
                looks.lock().expect("no thread panics here").extend(parts);
            });
            let mut found = looks.into_inner().expect("as above");
            found.sort_unstable();
            let cut = |row: usize| -> Vec<Range<usize>> {
                let step = [1, chunk][which.min(1)];
                match which {
                    2 => (0..workers).map(|member| fixed_part(row, workers, member)).collect(),
                    _ => (0..row).step_by(step).map(|k| k..row.min(k + step)).collect(),
                }
            };
            let right = (0..n).flat_map(|a| {
                let parts = cut(n - a - 1).into_iter().filter(|part| !part.is_empty());
                parts.flat_map(move |part| [a, a + 1 + part.start, a + 1 + part.end])
            });
            let question = format!(
                "{name} of {n} discs, {workers} workers, chunks of {chunk}: disc, first partner and end of each \
                 part of a row"
            );
            ask(&question, whole(found.concat()), whole(right));
        }
    }
    for (name, share) in [SHARES[0], SHARES[2]] {
        let (n, others, seen) = (40, AtomicUsize::new(0), AtomicUsize::new(usize::MAX));
        let queue = Schedule::Dynamic { chunk: 1 };
        share(n, Team::Fresh(2), queue, &|_, a, partners: Range<usize>| {
            let begin = Instant::now();
            while a == 0 && others.load(Relaxed) < n - 2 && begin.elapsed() < Duration::from_secs(5)
            {
                thread::yield_now();
            }
            // Each row ends with the last disc.
            if a > 0 && partners.contains(&(n - 1)) {
                others.fetch_add(1, Relaxed);
            }
            if a == 0 {
                seen.fetch_min(others.load(Relaxed), Relaxed);
            }
        });
        let question = format!(
            "{name} of {n} discs from a queue, disc 0's worker is held up: rows that others do meanwhile"
        );
        ask(&question, whole([seen.into_inner()]), whole([n - 2]));
    }
}

/// Where threads come that look at pairs.
static LOOKS: Share = Share::new();

/// Whether the threads of a team share the pairs, in fixed parts and from a queue. Of the inner loop one row is asked
/// about: the next one begins when all are done with it, so nobody can be held back for longer than a row.
pub(super) fn shared_loops(random: &mut Random, ask: Ask<'_>) {
    let count = 4 + random.below(3);
    let workers = Workers::new(count).expect("some threads start");
    for (which, (name, share)) in SHARES.into_iter().enumerate() {
        for schedule in [Schedule::Static, Schedule::Dynamic { chunk: 1 }] {
            let (n, row) = (60 + random.below(40), random.below(20));
            let of_row = which == 1;
            let pairs = if of_row { n - row - 1 } else { n * (n - 1) / 2 };
            let mut found = LOOKS.of(count, pairs as u64, || {
                share(n, Team::Standing(&workers), schedule, &|_, a, partners: Range<usize>| {
                    if !partners.is_empty() && (a == row || !of_row) {
                        LOOKS.does(count, partners.len() as u64);
                    }
                });
            });
            // Both loops start threads for each row.
            found[0] = found[0].min(count as f64);
            let what = if of_row { format!("row {row}") } else { "all rows".into() };
            let question = format!(
                "{name} of {n} discs on a team of {count}, {schedule:?}, {what}: how many threads look at pairs, and does \
                 one of them look at more than two thirds (1)"
            );
            ask(&question, vec![found[0], found[2]], vec![count as f64, 0.0]);
        }
    }
}

/// Each row of both loops has a team of its own: who is not the first in it is no thread of the team that has the rows.
pub(super) fn fresh_teams(ask: Ask<'_>) {
    let workers = Workers::new(2).expect("two threads start");
    let team = Team::Standing(&workers);
    let (standing, seen) = (Mutex::new(Vec::new()), AtomicUsize::new(0));
    let id = || thread::current().id();
    team.on_each(|_| standing.lock().expect("no thread panics here").push(id()));
    let standing = standing.into_inner().expect("as above");
    nested(20, team, Schedule::Static, |list, _, _| {
        seen.fetch_add(usize::from(list % 2 > 0 && standing.contains(&id())), Relaxed);
    });
    let question = "both loops of 20 discs, on a team of 2 that waits for work: parts of the second worker of a row's \
                    team that a thread of that team did";
    ask(question, whole([seen.into_inner()]), whole([0]));
}

/// Boxes of fast and slow discs, in windows of any length.
pub(super) fn spans(random: &mut Random, ask: Ask<'_>) {
    for case in 0..2000 {
        let count = 1 + random.size(4097);
        let windows = [
            Window::part(random.below(count), count),
            Window::STEP,
            Window { from: 0.25, to: 1.5 },
        ];
        let window = windows[case % 3];
        let unit = random.magnitude(1e-12, 1e12);
        let (x, v) = (unit * random.signed(1e-3, 1e3), unit * random.signed(1e-9, 1e3));
        let v = if case % 7 == 0 { 0.0 } else { v };
        let reach = unit * random.magnitude(1e-6, 1e3);
        let (start, end) = (x + v * window.from, x + v * window.to.min(1.0));
        let (low, high) = (start.min(end) - reach, start.max(end) + reach);
        let found = span(x, v, window, reach);
        let scale = 1e-3 * (x.abs() + v.abs() + reach);
        let question = format!(
            "low and high of the box of x = {x:?}, v = {v:?} from λ = {} to {}, reach {reach:?}",
            window.from, window.to
        );
        ask(
            &question,
            vec![rounded(found.low, low, scale), rounded(found.high, high, scale)],
            vec![low, high],
        );
    }
}

/// Boxes inside blocks, over edges, with ends on edges or beside them, and beyond the square.
pub(super) fn blocks(random: &mut Random, ask: Ask<'_>) {
    for case in 0..6000 {
        // A quarter of the side has no rounding.
        let side = random.magnitude(1e-12, 1e12).log2().round().exp2();
        let end = |random: &mut Random| match random.below(5) {
            0 => beside(random.below(5) as f64 * 0.25 * side)[random.below(3)],
            1 => random.signed(1e-3, 10.0) * side,
            _ => random.between(0.0, side),
        };
        let edges = |random: &mut Random| {
            let low = end(random);
            let other = low + [0.01, 0.2, 0.6][case % 3] * side * random.between(0.0, 1.0);
            let high = if random.below(3) == 0 { end(random) } else { other };
            Span { low: low.min(high), high: low.max(high) }
        };
        let (x, y) = (edges(random), edges(random));
        let column = |at: f64, blocks: usize| {
            (1..blocks).filter(|&k| at >= k as f64 * (side / blocks as f64)).count()
        };
        let fits = |blocks: usize, first: usize| {
            let [left, right, low, high] =
                [x.low, x.high, y.low, y.high].map(|at| column(at, blocks));
            (left == right && low == high).then_some(first + blocks * low + left)
        };
        let right = fits(4, 0).or_else(|| fits(2, 16)).unwrap_or(20);
        let question = format!("the block of {x:?} × {y:?} in a square of {side:?}");
        ask(&question, whole([block_of(x, y, side)]), whole([right]));
    }
    for block in 0..21 {
        let mut found = blocks_around(block);
        found.sort_unstable();
        ask(&format!("the blocks around block {block}"), whole(found), whole(around(block)));
    }
}

/// The blocks around block `block`, by their numbers.
fn around(block: usize) -> Vec<usize> {
    match block {
        0..16 => vec![16 + 2 * (block / 4 / 2) + block % 4 / 2, 20],
        16..20 => vec![20],
        _ => vec![],
    }
}

/// Discs in any blocks, in all of one level or in one: who meets whom, and how often.
pub(super) fn grids(random: &mut Random, ask: Ask<'_>) {
    for case in 0..120 {
        let mut blocks = vec![Vec::new(); 21];
        let mut all = Vec::new();
        let (n, crowd) = (random.below(1 + case), random.below(21));
        for k in 0..n {
            let block = [random.below(21), random.below(16), crowd, 16 + random.below(5)][case % 4];
            // Neither in the order of their numbers, nor without gaps.
            let disc = (k * 7919 % 4097 * 70_001) as u32;
            blocks[block].push(disc);
            all.push((disc, block));
        }
        let mut found = Vec::new();
        for (block, discs) in blocks.iter().enumerate() {
            for (index, &disc) in discs.iter().enumerate() {
                look_around(&blocks, block, index, |partners| {
                    found.extend(partners.iter().map(|&other| [disc.min(other), disc.max(other)]));
                });
            }
        }
        let mut right = Vec::new();
        for (k, &(a, p)) in all.iter().enumerate() {
            for &(b, q) in &all[..k] {
                if p == q || around(p).contains(&q) || around(q).contains(&p) {
                    right.push([a.min(b), a.max(b)]);
                }
            }
        }
        found.sort_unstable();
        right.sort_unstable();
        let pairs = |pairs: Vec<[u32; 2]>| whole(pairs.concat().into_iter().map(|n| n as usize));
        let question = format!("all pairs that may meet, of {n} discs in blocks {blocks:?}");
        ask(&question, pairs(found), pairs(right));
    }
    let mut blocks = vec![Vec::new(); 21];
    blocks[20] = (0..70_000).collect();
    let mut found = 0;
    for index in 0..70_000 {
        look_around(&blocks, 20, index, |partners| found += partners.len());
    }
    ask("all pairs of 70,000 discs in the whole square", whole([found]), whole([69_999 * 35_000]));
}

/// Few and many boxes in few and many cells, narrow and wide.
pub(super) fn columns(random: &mut Random, ask: Ask<'_>) {
    for case in 0..60 {
        let columns = [3_usize, 20, 300, 70_000, 1 << 31][case % 5];
        let rows = [1_usize, 4, 70_000, 1 << 20][case % 4];
        let crowd = case % 3 == 0;
        let mut entries: Vec<_> = (0..random.size(400.min(2 + 8 * case)) as u32 + 1)
            .map(|disc| {
                let row = rows - 1 - random.below(rows.min(3));
                let column = if crowd { columns / 2 } else { random.below(columns) };
                let further = random.size((columns - 1 - column).min(70_000)) as u32;
                Entry::new((row * columns + column) as u64, further, disc, true)
            })
            .collect();
        entries.sort_by_key(|entry| entry.cell);
        for (k, entry) in entries.iter().enumerate() {
            let found = partners(&entries, k);
            let last = entry.cell + u64::from(entry.further);
            let right = k + 1
                ..k + 1 + entries[k + 1..].iter().take_while(|entry| entry.cell <= last).count();
            let behind: Vec<u64> =
                entries[k + 1..].iter().take(6).map(|entry| entry.cell).collect();
            let question = format!(
                "{} entries in rows of {columns} columns, entry {k} begins in cell {} and goes on for {} more, those \
                 behind it begin in {behind:?}: the first that shares a column with it, and the first behind these",
                entries.len(),
                entry.cell,
                entry.further
            );
            ask(&question, whole([found.start, found.end]), whole([right.start, right.end]));
        }
    }
}

/// Cells whose numbers differ by 2^32, and one of the last number of 32 bits.
pub(super) fn far_columns(ask: Ask<'_>) {
    let far = 1 << 32;
    for (cells, further, right) in
        [([5, far + 5], 0, 1..1), ([far - 1, far], 1, 1..2), ([far - 1, far + 1], 1, 1..1)]
    {
        let entries = cells.map(|cell| Entry::new(cell, further, 0, true));
        let found = partners(&entries, 0);
        let question = format!(
            "entries that begin in cells {cells:?}, and go on for {further} more: the first that shares a column with \
                 entry 0, and the first behind these"
        );
        ask(&question, whole([found.start, found.end]), whole([right.start, right.end]));
    }
}

/// Many narrow boxes: who goes through all the rest for each does not come to an end.
pub(super) fn many_columns(ask: Ask<'_>) {
    let entries: Vec<Entry> =
        (0..1_000_000).map(|k: u32| Entry::new(u64::from(k), k % 3, k, true)).collect();
    let shared = |k: usize| partners(&entries, k).len();
    let found = (0..entries.len()).map(shared).sum();
    let question = "a million boxes one column from the next, of 1, 2 and 3 columns in turn: how often two share one";
    ask(question, whole([found]), whole([999_998]));
}

/// Slow and fast scenes, thin and dense, with and without crowds: is any other number of windows cheaper?
pub(super) fn windows(random: &mut Random, ask: Ask<'_>) {
    const ENTRY: f64 = 60.0;
    const ASK: f64 = 10.0;
    for case in 0..3000 {
        let (short, most) = (|number| short(case < 60, number), if case < 60 { 0.09 } else { 0.9 });
        let radius = short(random.magnitude(1e-9, 1e9));
        let n = short((1 + random.below(1_000_000)) as f64) as usize;
        let side = short(radius * (n as f64 * PI / random.magnitude(1e-9, most)).sqrt());
        let mut speed = || radius * short(random.magnitude(1e-3, 1e6));
        let speed = (speed(), speed());
        let everywhere = (radius, side - radius);
        let meetings = short(random.magnitude(1e-6, 1e3));
        let fastest = 2.0 * speed.0.max(speed.1);
        let survey = Survey { n, speed, fastest, x: everywhere, y: everywhere, meetings };
        let square = Square { side, radius };
        let crowding = short(random.magnitude(1e-3, 1e12));
        let cost = |windows: usize| {
            let work = expected_work(&survey, square, windows);
            ENTRY * work.entries + crowding * (work.pairs + ASK * work.asked)
        };
        let found = choose_windows(&survey, square, crowding);
        let least = (0..=12).map(|k| cost(1 << k)).fold(f64::INFINITY, f64::min);
        let may_be = found.is_power_of_two() && found <= 4096;
        let question = format!(
            "{survey:?} in a square of side {side:?}, radius {radius:?}, {crowding:?} times as many pairs as expected: \
             what its windows cost, by what the cheapest power of two up to 4096 costs; 0 if it is none"
        );
        let times = if may_be { cost(found) / least } else { 0.0 };
        ask(&question, vec![rounded(times, 1.0, 1.0)], vec![1.0]);
    }
}
