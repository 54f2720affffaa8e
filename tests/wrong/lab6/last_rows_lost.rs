// region: 6.1
// fails: task_6_1_blocks_are_cut_where_the_lab_says
// story: The last block gets as many rows as the first; the remainder of the division belongs to no rank.
let each = counts.len() / ranks;
Cuts { starts: (0..=ranks).map(|rank| rank * each).collect() }
