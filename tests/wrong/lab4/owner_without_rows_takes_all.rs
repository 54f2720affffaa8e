// region: 4.9b
// fails: task_4_9_owners_take_each_particle_once
// story: An owner without rows takes every particle. There is one as soon as there are more threads than rows.
let (grid, rows) = (*own.grid(), own.rows());
own.refill(all.filter(|p| rows.is_empty() || rows.contains(&grid.row(p.y))).copied());
