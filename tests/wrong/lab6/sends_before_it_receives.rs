// region: 6.3
// fails: task_6_3_lists_reach_the_neighbours_while_work_is_done
// story: Every rank sends first and receives afterwards, with operations that block. Short lists are kept aside by the library and all is well; with long ones all ranks wait for each other.
let result = work();
for (rank, list) in outgoing {
    world.process_at_rank(*rank).send(&list[..]);
}
let mut incoming = Vec::new();
for (rank, _) in outgoing {
    let (list, _) = world.process_at_rank(*rank).receive_vec::<T>();
    incoming.push(list);
}
(incoming, result)
