// region: 7.13
// fails: task_7_13_boxes_that_share_a_column
// story: All entries behind the box are looked at, though those that share a column follow it directly.
let last = entries[k].cell + u64::from(entries[k].further);
let shared = entries[k + 1..].iter().filter(|entry| entry.cell <= last).count();
k + 1..k + 1 + shared
