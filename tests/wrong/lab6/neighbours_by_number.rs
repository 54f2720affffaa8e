// region: 6.2
// fails: task_6_2_neighbours_have_the_rows_next_door, task_6_7_all_particles_in_a_few_rows
// story: The neighbours are the ranks with the numbers next to one's own, even if their blocks are empty.
let _ = (block, rows);
[rank.checked_sub(1), (rank + 2 < cuts.starts.len()).then_some(rank + 1)]
