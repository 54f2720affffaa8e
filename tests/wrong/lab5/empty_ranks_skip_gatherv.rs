// region: 5.4
// fails: task_5_4_the_root_gets_everything_in_the_order_of_ranks
// loses: 5.8
// story: A rank that has no items leaves out the Gatherv, since it has nothing to send. Many an MPI library lets that pass, until another algorithm makes that rank pass on what others send.
if world.rank() != ROOT {
    root.gather_into(&count);
    if !items.is_empty() {
        root.gather_varcount_into(items);
    }
    return Vec::new();
}
let mut counts: Vec<Count> = vec![0; world.size() as usize];
root.gather_into_root(&count, &mut counts[..]);
let mut all = vec![Wire::default(); total(&counts)];
let mut parts = PartitionMut::new(&mut all[..], &counts[..], displacements(&counts));
root.gather_varcount_into_root(items, &mut parts);
split(&all, &counts)
