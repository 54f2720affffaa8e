//! Simple loops over discs, divided into pieces of equal length that workers share.
//!
//! The loops compute whether a disc hits a wall, and its new position. The CS3210 report writes
//! that these loops «do not allow much difference». The pieces are the same for any number of
//! threads.

use workers::Workers;

/// Number of discs in a piece.
const PIECE: usize = 4096;

/// Calls `act` with the index of every item and the item.
pub(crate) fn for_each<T: Send>(
    workers: &Workers,
    items: &mut [T],
    act: impl Fn(usize, &mut T) + Send + Sync,
) {
    workers.map(items.chunks_mut(PIECE).enumerate().collect(), |(k, piece): (usize, &mut [T])| {
        for (i, item) in piece.iter_mut().enumerate() {
            act(k * PIECE + i, item);
        }
    });
}

/// Calls `work` with each piece and the index of its first item, and returns the results.
pub(crate) fn map_pieces<T: Sync, U: Send>(
    workers: &Workers,
    items: &[T],
    work: impl Fn(usize, &[T]) -> U + Send + Sync,
) -> Vec<U> {
    let pieces = items.chunks(PIECE).enumerate().collect();
    workers.map(pieces, |(k, piece): (usize, &[T])| work(k * PIECE, piece))
}

/// Calls `find` with the index of every item and the item, and appends the results to `out` in
/// order.
pub(crate) fn collect<T: Sync, U: Send>(
    workers: &Workers,
    items: &[T],
    out: &mut Vec<U>,
    find: impl Fn(usize, &T) -> Option<U> + Send + Sync,
) {
    let found = map_pieces(workers, items, |first, piece| -> Vec<U> {
        piece.iter().enumerate().filter_map(|(k, item)| find(first + k, item)).collect()
    });
    out.extend(found.into_iter().flatten());
}
