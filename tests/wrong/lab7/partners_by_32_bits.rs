// region: 7.13
// fails: task_7_13_boxes_that_share_a_column
// story: Cell numbers are compared in 32 bits: an entry in cell 5 has a partner in cell 2^32 + 5, and one that begins at 2^32 − 1 none in 2^32.
let first = entries[k].cell as u32;
let mut end = k + 1;
while end < entries.len()
    && (entries[end].cell as u32).wrapping_sub(first) <= entries[k].further
    && entries[end].cell as u32 >= first
{
    end += 1;
}
k + 1..end
