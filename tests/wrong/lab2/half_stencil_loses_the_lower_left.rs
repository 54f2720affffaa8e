// region: 2.7
// fails: task_2_7_linked_list_crowds, task_2_7_linked_list_pairs_over_every_edge, task_2_7_linked_list_steps
// story: Right, below and lower right, as in a picture of four squares: pairs that meet at the lower left are lost.
let mut count = 0;
for near_row in row..grid.near(row).end {
    for near_column in column..grid.near(column).end {
        if (near_row, near_column) > (row, column) {
            bins[count] = near_row * grid.columns() + near_column;
            count += 1;
        }
    }
}
count
