// region: 2.7
// fails: task_2_7_forward_bins_of_any_grid
// story: Numbers of bins are kept in 16 bits: in 300 rows the upper ones are others.
let mut count = 0;
for near_row in grid.near(row) {
    for near_column in grid.near(column) {
        if (near_row, near_column) > (row, column) {
            bins[count] = usize::from((near_row * grid.columns() + near_column) as u16);
            count += 1;
        }
    }
}
count
