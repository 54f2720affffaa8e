// region: 4.9b
// fails: task_4_9_owners_take_each_particle_once
// story: The row after the last belongs to the owner as well: its bins do not hold what lies there.
let (grid, rows) = (*own.grid(), own.rows());
own.refill(all.filter(|p| rows.start <= grid.row(p.y) && grid.row(p.y) <= rows.end).copied());
