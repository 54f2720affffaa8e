// region: 8.9
// fails: task_8_9_ghosts_go_where_their_boxes_reach, task_8_13_only_what_crosses_a_cut_travels
// story: Every partner gets every disc. The results are right, and each rank sends what the master did.
let _ = (strips, reach);
for list in &mut lists {
    list.extend_from_slice(own);
}
