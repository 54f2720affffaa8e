//! Chapter 3: the change buffers of two workers, which all threads empty.

use common::soft::{NoStatistics, Particle};
use oracle::Columns;
use rayon::prelude::*;
use solution2::VecBins;
use solution3::{Worker, own_bins, pool, rows_of_each, sum_and_move, take_arrivals};

use crate::eight::{grid, numbers, particles};

type Workers = Vec<Box<Worker<NoStatistics>>>;

#[test]
fn change_buffers() {
    let grid = grid();
    let mut bins = VecBins::new(grid);
    bins.refill(&particles());
    let mut workers: Workers =
        rows_of_each(2, grid.rows()).map(Worker::new).map(Box::new).collect();
    let mut table = Columns::new((0..2).map(|number| format!("worker {number}")));
    table.row("rows of bins", in_rows(&mut bins, &workers));
    for step in 1..=2 {
        pool(2).install(|| {
            sum_and_move(&mut workers, &mut bins);
            table.row(format!("step {step}, moved: in the bins"), in_rows(&mut bins, &workers));
            let buffers = || workers.iter().map(|worker| &worker.changed[..]);
            table.row("  in the change buffer", buffers().map(numbers));
            let own = own_bins(&mut bins, &workers);
            workers.par_iter().zip(own).for_each(|(worker, own)| {
                take_arrivals(&grid, worker.rows.start * grid.columns(), own, buffers());
            });
            table.row("  arrivals taken: in the bins", in_rows(&mut bins, &workers));
        });
    }
    insta::assert_snapshot!(table);
}

/// Lists the contents of each worker's bins, row by row.
fn in_rows(bins: &mut VecBins, workers: &Workers) -> Vec<String> {
    let columns = bins.grid().columns();
    let own = own_bins(bins, workers);
    let row = |row: &[Vec<Particle>]| numbers(row.iter().flatten());
    own.into_iter().map(|own| own.chunks(columns).map(row).collect::<Vec<_>>().join("|")).collect()
}
