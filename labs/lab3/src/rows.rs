//! Task 3.2: which rows belong to which thread.

use std::ops::Range;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The rows of bins that belong to worker `worker` of `workers`, out of `rows` rows.
///
/// Worker k has the rows from k · R / p up to, without, (k + 1) · R / p, in integer arithmetic, for
/// R rows and p workers. Then every row has one owner, nobody has more than one row more than
/// another, and workers beyond the number of rows have none. (R / p rows for everybody and the rest
/// for the last is the obvious cut, and the wrong one: 15 rows among 8 would be one each, and 8 for
/// the last.)
///
/// Book: chapter 3, *Who owns what*.
pub fn own_rows(worker: usize, workers: usize, rows: usize) -> Range<usize> {
    todo!("task 3.2: which rows belong to which thread")
}

/// The rows of every worker, in order.
pub fn rows_of_each(workers: usize, rows: usize) -> impl Iterator<Item = Range<usize>> {
    (0..workers).map(move |worker| own_rows(worker, workers, rows))
}

/// A team of exactly `threads` threads.
///
/// # Panics
/// The system refuses so many threads.
pub fn team(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap_or_else(|e| panic!("cannot start {threads} threads: {e}"))
}
