//! Sorting particles by cell where most cells hold nobody.

use crate::{Bodies, Grid, Kind};

/// Sorts `from` into `to` by the cells of `grid` where free flight takes the particles within time
/// `ahead`. Only cells that hold somebody are stored.
pub(crate) fn sort_sparse(from: &Bodies, to: &mut Bodies, grid: Grid, ahead: f64) -> Kind {
    let key = |i: usize| {
        let column = grid.column(from.x[i] + from.vx[i] * ahead);
        u64::from(grid.row(from.y[i] + from.vy[i] * ahead)) * u64::from(grid.columns)
            + u64::from(column)
    };
    let mut order: Vec<(u64, u32)> = (0..from.len()).map(|i| (key(i), i as u32)).collect();
    order.sort_unstable();
    let (mut keys, mut starts) = (Vec::new(), Vec::new());
    for (place, &(key, i)) in order.iter().enumerate() {
        if keys.last() != Some(&key) {
            keys.push(key);
            starts.push(place as u32);
        }
        to.set(place, from.get(i as usize));
    }
    starts.push(order.len() as u32);
    Kind::Sparse { keys, starts }
}
