//! Task 3.3: the rows of each thread.

use std::ops::Range;

/// Returns the rows of bins that belong to worker `worker` of `workers`, out of `rows` rows.
///
/// - Every row has exactly one owner.
/// - The rows of worker k + 1 follow the rows of worker k.
/// - The numbers of rows of two workers differ by at most 1. If there are more workers than rows,
///   some workers have no rows.
///
/// Any division with these properties is right.
///
/// Book: chapter 3, *Which rows a thread owns*.
pub fn own_rows(worker: usize, workers: usize, rows: usize) -> Range<usize> {
    // task 3.3: which rows belong to which thread
    let cut = |k: usize| k * rows / workers;
    cut(worker)..cut(worker + 1)
    // end 3.3
}

/// Returns the rows of every worker, in order.
pub fn rows_of_each(workers: usize, rows: usize) -> impl Iterator<Item = Range<usize>> {
    (0..workers).map(move |worker| own_rows(worker, workers, rows))
}
