// region: 4.9b
// fails: task_4_9_owners_take_each_particle_once, task_4_9_owner_computes
// story: The last of the own rows is left out, so its particles belong to no owner.
let (grid, rows) = (*own.grid(), own.rows());
let inside = rows.start..rows.end.saturating_sub(1);
own.refill(all.filter(|p| inside.contains(&grid.row(p.y))).copied());
