//! Questions about a notice that one thread posts and another reads.

use std::sync::Arc;

use common::soft::Statistics;
use lab3::{Atomic, Memory, Notice};
use oracle::{Ask, Random};

use super::reductions::{drawn, numbers};

/// A way in which a notice may be read while another thread posts it.
pub(crate) struct Reading {
    /// The notice that was read. `None` if no notice was found.
    pub(crate) found: Option<Statistics>,
    /// The operations of both threads, in words.
    pub(crate) log: String,
}

impl Reading {
    /// Returns the notice that was read, then the length of `log` in bytes, and its bytes.
    fn into_numbers(self) -> Vec<f64> {
        let read = [answer(self.found), vec![self.log.len() as f64]].concat();
        read.into_iter().chain(self.log.bytes().map(f64::from)).collect()
    }
}

/// Returns all readings that the orderings of the program's operations allow.
pub(crate) fn readings(posted: &Statistics) -> Vec<Reading> {
    let memory = Arc::new(Memory::default());
    let number = |name, bits| Atomic::watched(bits, &memory, name);
    let before = Statistics::default();
    let notice = Notice {
        dmin: number("dmin", before.dmin.to_bits()),
        davg: number("davg", before.davg.to_bits()),
        navg: number("navg", before.navg),
        pair_tests: number("pair_tests", before.pair_tests),
        posted: number("the flag", 0),
    };
    let readings = memory.readings(|| notice.post(posted), || notice.read());
    readings.into_iter().map(|(found, log)| Reading { found, log }).collect()
}

/// Returns 1 and the numbers of a notice, or 0 if there is no notice.
fn answer(notice: Option<Statistics>) -> Vec<f64> {
    notice.map_or(vec![0.0], |s| [vec![1.0], numbers(&s)].concat())
}

/// Asks for notices with numbers of any size.
pub(crate) fn posts(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..20 {
        let posted = drawn(random);
        let notice = Notice::default();
        let name = format!(
            "notice {case} (answers: 1 and dmin, davg, navg, pair tests; or 0 for no notice)"
        );
        let question = format!("{name}: result of a read before the notice is posted");
        ask.exact(&question, || answer(notice.read()), || vec![0.0]);
        notice.post(&posted);
        let question = format!("{name}: result of a read after the notice is posted");
        ask.exact(&question, || answer(notice.read()), || answer(Some(posted)));
        let found = || {
            let all = readings(&posted).into_iter();
            let mut all: Vec<Vec<f64>> = all.map(|reading| answer(reading.found)).collect();
            all.sort_by(|a, b| a.partial_cmp(b).expect("numbers can be compared"));
            all.dedup();
            all.concat()
        };
        let question = format!(
            "{name}: all results that a thread may read while another thread posts the notice"
        );
        ask.exact(&question, found, || [vec![0.0], answer(Some(posted))].concat());
    }
}

/// Asks for the readings of one notice, each with the operations of both threads.
pub(crate) fn orderings(_: &mut Random, ask: &mut impl Ask) {
    let posted = Statistics { dmin: 0.25, davg: 1.5, navg: 4, pair_tests: 9 };
    let found = || readings(&posted).into_iter().flat_map(Reading::into_numbers).collect();
    let question = "a notice with dmin 0.25, davg 1.5, navg 4 and 9 pair tests: every possible result of a read while \
                    another thread posts the notice";
    ask.judge(question, found, |found| {
        let mut rest = found;
        while !rest.is_empty() {
            let reading = next_reading(&mut rest).ok_or("the answer is not complete")?;
            let Reading { found, log } = reading;
            if let Some(read) = found.filter(|read| *read != posted) {
                let both = format!("{read:?} was read, but {posted:?} was posted");
                return Err(format!("the thread saw the flag, but not all numbers: {both}\n{log}"));
            }
            if let Some(words) = too_much(&log) {
                return Err(format!("{words}\n{log}"));
            }
        }
        Ok(())
    });
}

/// Names an operation in `log` that is stronger than necessary or repeated. Returns `None` if all
/// operations are needed.
fn too_much(log: &str) -> Option<String> {
    let needed = [
        "writes the flag, Release",
        "reads  the flag, Acquire",
        "the writer passes a fence, Release",
        "the reader passes a fence, Acquire",
    ];
    let is_needed = |line: &&str| {
        line.contains(", Relaxed") || needed.iter().any(|needed| line.contains(needed))
    };
    if let Some(line) = log.lines().find(|line| !is_needed(line)) {
        return Some(format!("'{}': a weaker ordering is sufficient", line.trim()));
    }
    let looks = log.lines().filter(|line| line.contains("reads  the flag")).count();
    (looks > 1).then(|| format!("the flag is read {looks} times instead of once"))
}

/// Takes a reading off the front of an answer.
fn next_reading(rest: &mut &[f64]) -> Option<Reading> {
    let mut take = |count: usize| {
        let (taken, behind) = rest.split_at_checked(count)?;
        *rest = behind;
        Some(taken)
    };
    let found = match take(1)? {
        [1.0] => {
            let of = take(4)?;
            let counts = [of[2] as u64, of[3] as u64];
            Some(Statistics { dmin: of[0], davg: of[1], navg: counts[0], pair_tests: counts[1] })
        }
        _ => None,
    };
    let length = take(1)?[0] as usize;
    let bytes = take(length)?.iter().map(|byte| *byte as u8).collect();
    Some(Reading { found, log: String::from_utf8(bytes).ok()? })
}
