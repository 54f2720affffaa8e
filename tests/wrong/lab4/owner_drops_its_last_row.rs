// region: 4.6
// fails: task_4_6_owners_take_everybody_once, task_4_6_owner_computes
// story: The last of the own rows is left out, so its particles belong to nobody.
let (grid, rows) = (*own.grid(), own.rows());
let inside = rows.start..rows.end.saturating_sub(1);
own.refill(everybody.filter(|p| inside.contains(&grid.row(p.y))).copied());
