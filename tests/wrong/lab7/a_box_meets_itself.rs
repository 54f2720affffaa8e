// region: 7.13
// fails: task_7_13_boxes_that_share_a_column
// story: Every box is looked at with itself as well: no result is wrong, only as many looks too many as there are entries.
let last = entries[k].cell + u64::from(entries[k].further);
let mut end = k + 1;
while end < entries.len() && entries[end].cell <= last {
    end += 1;
}
k..end
