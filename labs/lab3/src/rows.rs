//! Task 3.3: which rows belong to which thread.

use std::ops::Range;

/// The rows of bins that belong to worker `worker` of `workers`, out of `rows` rows.
///
/// Every row has one owner, each worker's rows follow those of the worker before, and no worker has
/// more than one row more than another. So some have none where workers outnumber rows. Any cut that
/// is so will do.
///
/// Book: chapter 3, *Which rows a thread owns*.
pub fn own_rows(worker: usize, workers: usize, rows: usize) -> Range<usize> {
    todo!("task 3.3: which rows belong to which thread")
}

/// The rows of every worker, in order.
pub fn rows_of_each(workers: usize, rows: usize) -> impl Iterator<Item = Range<usize>> {
    (0..workers).map(move |worker| own_rows(worker, workers, rows))
}
