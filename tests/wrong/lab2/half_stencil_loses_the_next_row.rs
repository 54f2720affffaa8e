// region: 2.7
// fails: task_2_7_linked_list_crowds, task_2_7_linked_list_pairs_over_every_edge, task_2_7_linked_list_steps
// story: Only the bin to the right comes after: pairs across a row are lost.
let next = column + 1;
if next < grid.columns() {
    bins[0] = row * grid.columns() + next;
    return 1;
}
0
