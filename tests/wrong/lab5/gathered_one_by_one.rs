// region: 5.4
// fails: task_5_4_the_root_gets_everything_in_the_order_of_ranks
// story: Each rank sends to the root, which receives from one after the other: right, and no collective operation.
if world.rank() != ROOT {
    root.send(&count);
    root.send(items);
    return Vec::new();
}
let mut lists = vec![items.to_vec()];
for rank in 1..world.size() {
    let other = world.process_at_rank(rank);
    let (count, _) = other.receive::<Count>();
    let mut list = vec![Wire::default(); count as usize];
    other.receive_into(&mut list[..]);
    lists.push(list);
}
lists
