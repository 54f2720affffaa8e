// region: 5.4
// fails: task_5_4_the_root_gets_everything_in_the_order_of_ranks
// loses: 5.8
// story: The parts of all ranks are put into the same index of the buffer: each overwrites the one before.
if world.rank() != ROOT {
    root.gather_into(&count);
    root.gather_varcount_into(items);
    return Vec::new();
}
let mut counts: Vec<Count> = vec![0; world.size() as usize];
root.gather_into_root(&count, &mut counts[..]);
let mut all = vec![Wire::default(); total(&counts)];
let zeros = vec![0; counts.len()];
let mut parts = PartitionMut::new(&mut all[..], &counts[..], zeros);
root.gather_varcount_into_root(items, &mut parts);
split(&all, &counts)
