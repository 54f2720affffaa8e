//! The worked examples of tasks 7.8 to 7.14: loops of a few iterations, and boxes of a few discs.

use std::ops::Range;
use std::sync::Mutex;

use hard_discs::{
    Candidate, Entry, Hit, LockedCount, Schedule, SharedCount, Slots, Span, Square, Survey, Team,
    Window, expected_work,
};
use lab7::{
    append_atomic, append_locked, block_of, blocks_around, choose_windows, fixed_part, look_around,
    next_part, partners, span,
};
use oracle::{Ask, Random, Table, ascending, spaced};

use super::loops::SHARES;

pub(crate) fn part_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["how", "who or when", "iterations"]);
        for (n, workers) in [(12, 4), (12, 1), (0, 2)] {
            let how = format!("{n} in fixed parts for {workers}");
            for worker in 0..workers {
                let part = fixed_part(n, workers, worker);
                table.row([&how, &format!("worker {worker}"), &spaced(part)]);
            }
        }
        for (n, chunk) in [(10, 4), (6, 3)] {
            let how = format!("{n} from the queue, {chunk} at a time");
            let next = SharedCount::default();
            for time in 1..=n / chunk + 2 {
                let part = next_part(&next, n, chunk);
                let part = part.map_or("none are left".into(), spaced);
                table.row([&how, &format!("call {time}"), &part]);
            }
        }
        table.to_string()
    });
}

/// Returns the list that receives a pair: six discs, two workers, fixed parts.
fn list_of(which: usize, pair: (usize, usize)) -> String {
    let lists = Mutex::new(Vec::new());
    let (_, share) = SHARES[which];
    share(6, Team::Fresh(2), Schedule::Static, &|list, a, partners: Range<usize>| {
        if a == pair.0 && partners.contains(&pair.1) {
            lists.lock().expect("no thread panics while it holds this lock").push(list);
        }
    });
    ascending(lists.into_inner().expect("as above"))
}

pub(crate) fn loop_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["discs", "outer", "inner", "both"]);
        // Rows have an even number of partners, so that only one division into fixed parts is
        // possible.
        for pair in [(1, 2), (1, 3), (1, 4), (1, 5), (3, 4), (3, 5)] {
            let lists: Vec<String> = (0..3).map(|which| list_of(which, pair)).collect();
            let discs = format!("{} and {}", pair.0, pair.1);
            table.row([&discs, &lists[0], &lists[1], &lists[2]]);
        }
        table.to_string()
    });
}

pub(crate) fn slot_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let [locked, free] = [(); 2].map(|()| Slots::default());
        let lock = LockedCount::default();
        let count = SharedCount::default();
        let mut table = Table::new(["appended", "under a lock", "count", "without", "count"]);
        for (a, b) in [(0, 1), (0, 2), (1, 3)] {
            let candidate = Candidate { time: 0.5, hit: Hit::Pair(a, b) };
            append_locked(&locked, &lock, candidate);
            append_atomic(&free, &count, candidate);
            let words = |c: Candidate| format!("{}+{}", c.hit.first(), c.hit.second().unwrap_or(0));
            let under_lock = lock.locked(|count| *count);
            let without = count.load();
            table.row([
                &words(candidate),
                &spaced(locked.first(under_lock).map(words)),
                &under_lock,
                &spaced(free.first(without).map(words)),
                &without,
            ]);
        }
        table.to_string()
    });
}

pub(crate) fn span_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "v", "from λ", "to", "reach", "low", "high", ""]);
        for (x, v, window, reach, what) in [
            (4.0, 8.0, Window::STEP, 1.0, "from 4 to 12, and 1 more on both sides"),
            (4.0, -8.0, Window::STEP, 1.0, "from -4 to 4"),
            (4.0, 8.0, Window::part(1, 4), 1.0, "from 6 to 8"),
            (4.0, 8.0, Window::part(3, 4), 1.0, "from 10 to 12: the step ends at 1"),
            (4.0, 0.0, Window::part(1, 4), 2.0, "at rest"),
        ] {
            let Span { low, high } = span(x, v, window, reach);
            let to = if window.to > 1.0 { "the end".into() } else { window.to.to_string() };
            let [low, high] = [low, high].map(|end| end + 0.0);
            table.row([&x, &v, &window.from, &to, &reach, &low, &high, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn block_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "y", "block", "around it", ""]);
        for (x, y, what) in [
            ((0.5, 1.5), (0.5, 1.5), "small: column 0, row 0"),
            ((2.5, 3.5), (4.5, 5.5), "small: column 1, row 2"),
            ((2.0, 3.0), (0.5, 1.5), "from an edge: column 1"),
            ((1.0, 2.0), (0.5, 1.5), "to an edge: columns 0 and 1"),
            ((1.5, 2.5), (0.5, 1.5), "over an edge: medium"),
            ((4.5, 7.5), (5.0, 6.5), "medium: column 1, row 1"),
            ((3.0, 5.0), (0.5, 1.5), "over the middle"),
            ((-1.0, 1.0), (7.5, 8.5), "beyond: column 0, row 3"),
        ] {
            let [x, y] = [x, y].map(|(low, high)| Span { low, high });
            let block = block_of(x, y, 8.0);
            let [wide, high] = [x, y].map(|span| format!("{} to {}", span.low, span.high));
            table.row([&wide, &high, &block, &ascending(blocks_around(block)), &what]);
        }
        table.to_string()
    });
}

pub(crate) fn look_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        // Block 5 is a small block in the medium block 16, and block 20 is the whole square.
        let places = [("0", 0), ("1", 0), ("2", 5), ("3", 16), ("4", 20)];
        let mut blocks = vec![Vec::new(); 21];
        for (disc, (_, block)) in (0..).zip(places) {
            blocks[block].push(disc);
        }
        let mut looks = [[0; 5]; 5];
        for (block, discs) in blocks.iter().enumerate() {
            for (index, &disc) in discs.iter().enumerate() {
                look_around(&blocks, block, index, |partners| {
                    for &other in partners {
                        looks[disc.min(other) as usize][disc.max(other) as usize] += 1;
                    }
                });
            }
        }
        let mut table =
            Table::new(["disc", "block", "with 0", "with 1", "with 2", "with 3", "with 4"]);
        for (a, (disc, block)) in places.into_iter().enumerate() {
            // A pair is shown at its lower disc, whichever of the two discs tests the other.
            let cells = [0, 1, 2, 3, 4].map(|b| match b > a {
                true => looks[a][b].to_string(),
                false => "-".into(),
            });
            let [zero, one, two, three, four] = &cells;
            table.row([&disc, &block, zero, one, two, three, four]);
        }
        table.to_string()
    });
}

pub(crate) fn partner_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        // Rows of ten columns.
        let cells = [(1, 2), (2, 0), (3, 1), (4, 0), (9, 0), (11, 8), (19, 0)];
        let all = (0..).zip(cells);
        let entries: Vec<Entry> =
            all.map(|(disc, (cell, further))| Entry::new(cell, further, disc, true)).collect();
        let mut table = Table::new(["entry", "row", "from column", "to column", "partners"]);
        for (k, entry) in entries.iter().enumerate() {
            let column = entry.cell % 10;
            let last = column + u64::from(entry.further);
            table.row([&k, &(entry.cell / 10), &column, &last, &spaced(partners(&entries, k))]);
        }
        table.to_string()
    });
}

pub(crate) fn window_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let square = Square { side: 1000.0, radius: 1.0 };
        let everywhere = (1.0, 999.0);
        let survey = Survey {
            n: 1000,
            speed: (100.0, 100.0),
            fastest: 200.0,
            x: everywhere,
            y: everywhere,
            meetings: 0.5,
        };
        let chosen = [0.1, 1.0, 10.0, 100.0]
            .map(|crowding| (crowding, choose_windows(&survey, square, crowding)));
        let mut table =
            Table::new(["windows", "entries", "pairs", "asked", "chosen if crowding is"]);
        for windows in (0..9).map(|k| 1 << k) {
            let work = expected_work(&survey, square, windows);
            let [entries, pairs, asked] = [work.entries, work.pairs, work.asked].map(f64::round);
            let by = chosen.iter().filter(|(_, count)| *count == windows);
            let crowding = spaced(by.map(|(crowding, _)| crowding));
            table.row([&windows, &entries, &pairs, &asked, &crowding]);
        }
        table.to_string()
    });
}
