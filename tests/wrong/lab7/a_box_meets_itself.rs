// region: 7.15
// fails: task_7_15_boxes_that_share_a_column
// story: Every box is looked at with itself as well: no result is wrong, only as many looks too many as there are entries.
for (k, a) in entries.iter().enumerate() {
    let last = a.cell + u64::from(a.further);
    for b in &entries[k..] {
        if b.cell > last {
            break;
        }
        meet(a, b);
    }
}
