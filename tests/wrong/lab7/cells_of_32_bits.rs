// region: 7.13
// fails: task_7_13_boxes_that_share_a_column
// story: Cells are numbered in 32 bits.
let last = (entries[k].cell + u64::from(entries[k].further)) as u32;
let mut end = k + 1;
while end < entries.len() && entries[end].cell as u32 <= last {
    end += 1;
}
k + 1..end
