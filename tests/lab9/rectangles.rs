//! Questions about the numbers of pairs: the rectangle of all pairs, and the invocation that takes
//! each pair.

use std::collections::BTreeSet;

use device_discs::hard::{Deal, HardKernels};
use lab9::Lab9;
use oracle::{Ask, Random};

use super::adapter::adapter;
use super::filters::{all_pairs, numbers, pairs_of};
use super::launched::{DEALT, RECTANGLE, Search, line, turn_of};

/// Asks for the numbers of all pairs: every pair has a number, and every number has a pair.
pub(crate) fn rectangles(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.4") else { return };
    let source = format!("{RECTANGLE}{}", Lab9::balanced());
    for n in [2, 3, 4, 5, 6, 7, 31, 64, 80 + random.below(40)] {
        let scene = line(n);
        let question = format!(
            "{n} discs: number of pairs that have a number, then both discs of each such pair"
        );
        let found = || {
            let rows = 0..(n - 1 + n % 2) as u32;
            let search = Search::of(&scene, &source);
            let search = Search { rows, everything: true, room: 10_000, ..search };
            let mut found = search.run::<f32>(gpu);
            found.list.sort_unstable();
            [vec![f64::from(found.count)], numbers(&found.list)].concat()
        };
        ask.exact(&question, found, || {
            let right: Vec<_> = all_pairs(n as u32).collect();
            [vec![right.len() as f64], numbers(&right)].concat()
        });
    }
}

const MANY: u32 = 100_000;

/// Returns the pair at a row and a column of the rectangle of [`MANY`] discs. [`MANY`] is even: see
/// the picture in balanced.wgsl.
fn pair_at(row: u32, column: u32) -> [u32; 2] {
    if column < row + 1 { [column, row + 1] } else { [MANY - 1 - column, MANY - 1 - row] }
}

/// Asks about rows whose pair numbers exceed 32 bits, and about early rows.
pub(crate) fn late_rows(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.4") else { return };
    let source = format!("{DEALT}{}", Lab9::balanced());
    let scene = line(MANY as usize);
    for row in [0, 1, 49_999, 50_000, 85_899, 85_900, 99_998, random.below(99_999) as u32] {
        let question = format!(
            "row {row} of the rectangle of {MANY} discs: number of pairs in this row, then both discs of each pair"
        );
        let found = || {
            let search = Search::of(&scene, &source);
            let search = Search { rows: row..row + 1, everything: true, room: 60_000, ..search };
            let mut found = search.run::<f32>(gpu);
            found.list.sort_unstable();
            [vec![f64::from(found.count)], numbers(&found.list)].concat()
        };
        ask.judge(&question, found, |found| are_of_row(found, row));
    }
}

/// Checks that the pairs of a row, and no others, are dealt.
fn are_of_row(found: &[f64], row: u32) -> Result<(), String> {
    let Some((count, pairs)) = found.split_first() else {
        return Err("the answer is empty".into());
    };
    let different: BTreeSet<_> = pairs_of(pairs).into_iter().collect();
    let right = (0..MANY / 2).map(|column| pair_at(row, column));
    let lost = right.filter(|pair| !different.contains(pair)).count();
    let different = different.len();
    let all = MANY / 2;
    if *count == f64::from(all) && different == all as usize && lost == 0 {
        return Ok(());
    }
    Err(format!(
        "{count} pairs are in the row, {different} of these pairs are different, and {lost} of the {all} right pairs \
         are missing"
    ))
}

/// Asks whether four invocations share the work on all rows: each does at most two fifths of it, or,
/// if the pairs are numbered, as much as the others.
pub(crate) fn turns(ask: &mut impl Ask, deal: Deal) {
    let (task, find, source) = match deal {
        Deal::Discs => ("9.3", "find_of_discs", Lab9::basic()),
        Deal::Pairs => ("9.4", "find_of_pairs", Lab9::balanced()),
    };
    let Some(gpu) = adapter(task) else { return };
    for n in [24, 61] {
        let scene = line(n);
        let passed_on = |turn: u32| {
            let source = turn_of(find, turn) + source;
            let search = Search::of(&scene, &source);
            let search = Search { rows: 0..n as u32, everything: true, room: 10_000, ..search };
            f64::from(search.run::<f32>(gpu).count)
        };
        let rule = match deal {
            Deal::Discs => "which must be at most two fifths of all pairs",
            Deal::Pairs => "of which no two may differ by more than 1",
        };
        let question = format!(
            "{find}, {n} discs, four invocations: number of pairs that each invocation passes on, {rule}"
        );
        ask.judge(
            &question,
            || [0, 1, 2, 3].map(passed_on).to_vec(),
            |found| match is_fair(found, deal) {
                true => Ok(()),
                false => Err(format!("one invocation does too much of the work: {found:?}")),
            },
        );
    }
}

/// Whether no invocation passes on too many pairs.
fn is_fair(passed_on: &[f64], deal: Deal) -> bool {
    let most = passed_on.iter().copied().fold(0.0, f64::max);
    match deal {
        Deal::Discs => 5.0 * most <= 2.0 * passed_on.iter().sum::<f64>(),
        Deal::Pairs => passed_on.iter().all(|one| most - one <= 1.0),
    }
}
