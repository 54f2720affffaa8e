// region: 7.13
// fails: task_7_13_boxes_that_share_a_column, task_7_13_cells_find_every_pair
// story: A box that begins in the last column of another is not met.
let last = entries[k].cell + u64::from(entries[k].further);
let mut end = k + 1;
while end < entries.len() && entries[end].cell < last {
    end += 1;
}
k + 1..end
