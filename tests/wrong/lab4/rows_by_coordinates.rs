// region: 4.9b
// fails: task_4_9_owners_take_each_particle_once
// story: Compares y with row · side, which rounds otherwise than Grid::row.
let (side, rows, all_rows) = (own.grid().bin_side(), own.rows(), own.grid().rows());
let bottom = rows.start as f64 * side;
let top = if rows.end == all_rows { f64::INFINITY } else { rows.end as f64 * side };
own.refill(all.filter(|p| !rows.is_empty() && p.y >= bottom && p.y < top).copied());
