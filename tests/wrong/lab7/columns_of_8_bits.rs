// region: 7.13
// fails: task_7_13_boxes_that_share_a_column
// story: Further columns are counted in 8 bits.
let last = entries[k].cell + u64::from(entries[k].further as u8);
let mut end = k + 1;
while end < entries.len() && entries[end].cell <= last {
    end += 1;
}
k + 1..end
