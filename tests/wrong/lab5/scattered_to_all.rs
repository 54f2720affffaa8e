// region: 5.6
// fails: task_5_6_every_rank_gets_what_is_its_own
// story: The root sends all lists to all ranks, and each takes its own: right, and each rank gets what is for the others.
let mut counts: Vec<Count> = vec![0; world.size() as usize];
let mut all = Vec::new();
if world.rank() == ROOT {
    counts = lists.iter().map(|list| list.len() as Count).collect();
    all = lists.concat();
}
root.broadcast_into(&mut counts[..]);
all.resize(total(&counts), Wire::default());
root.broadcast_into(&mut all[..]);
count += counts[world.rank() as usize];
let own = split(&all, &counts).swap_remove(world.rank() as usize);
assert_eq!(own.len(), count as usize);
own
