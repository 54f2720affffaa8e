// region: 2.7
// fails: task_2_7_linked_list_crowds, task_2_7_linked_list_steps
// story: The bins after are found by adding to the bin number: in a box of two columns one of them counts twice.
let own = row * grid.columns() + column;
let mut count = 0;
for bin in [own + 1, own + grid.columns() - 1, own + grid.columns(), own + grid.columns() + 1] {
    if bin < grid.bins() && bin != own {
        bins[count] = bin;
        count += 1;
    }
}
count
