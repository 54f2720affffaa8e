// region: 5.4
// fails: task_5_4_the_root_gets_everything_in_the_order_of_ranks
// story: The root waits for one more message before it gathers many items, a message that no rank sends: the job hangs, and the grader ends it and names the task.
if world.rank() != ROOT {
    root.gather_into(&count);
    root.gather_varcount_into(items);
    return Vec::new();
}
let mut counts: Vec<Count> = vec![0; world.size() as usize];
root.gather_into_root(&count, &mut counts[..]);
if counts.iter().any(|&count| count > 1000) {
    let _: (u8, _) = world.any_process().receive_with_tag(99);
}
let mut all = vec![Wire::default(); total(&counts)];
let mut parts = PartitionMut::new(&mut all[..], &counts[..], displacements(&counts));
root.gather_varcount_into_root(items, &mut parts);
split(&all, &counts)
