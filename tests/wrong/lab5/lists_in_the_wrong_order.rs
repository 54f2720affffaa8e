// region: 5.6
// fails: task_5_6_every_rank_gets_what_is_its_own
// loses: 5.8
// story: The lists are put into the buffer from the last rank to the first, but cut into parts in the other order.
if world.rank() != ROOT {
    root.scatter_into(&mut count);
    let mut items = vec![Wire::default(); count as usize];
    root.scatter_varcount_into(&mut items[..]);
    return items;
}
let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
root.scatter_into_root(&counts[..], &mut count);
let mut items = vec![Wire::default(); count as usize];
let all: Vec<Wire> = lists.iter().rev().flatten().copied().collect();
let parts = Partition::new(&all[..], &counts[..], displacements(&counts));
root.scatter_varcount_into_root(&parts, &mut items[..]);
items
