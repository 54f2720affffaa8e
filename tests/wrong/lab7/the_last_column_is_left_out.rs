// region: 7.15
// fails: task_7_15_boxes_that_share_a_column, task_7_15_cells_find_every_pair
// story: A box that begins in the last column of another is not met.
for (k, a) in entries.iter().enumerate() {
    let last = a.cell + u64::from(a.further);
    for b in &entries[k + 1..] {
        if b.cell >= last {
            break;
        }
        meet(a, b);
    }
}
