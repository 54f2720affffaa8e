// region: 5.6
// fails: task_5_6_every_rank_gets_what_is_its_own
// story: All counts go to all ranks, though each rank needs its own alone.
let ranks = world.size() as usize;
let mut counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
counts.resize(ranks, 0);
root.broadcast_into(&mut counts[..]);
count = counts[world.rank() as usize];
let mut items = vec![Wire::default(); count as usize];
if world.rank() != ROOT {
    root.scatter_varcount_into(&mut items[..]);
    return items;
}
let all = lists.concat();
let parts = Partition::new(&all[..], &counts[..], displacements(&counts));
root.scatter_varcount_into_root(&parts, &mut items[..]);
items
