// region: 6.4
// fails: task_6_4_every_list_reaches_its_rank
// loses: 6.7
// story: Each rank believes that the others have as much for it as it has for them.
let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
let outgoing = lists.concat();
let mut incoming = vec![T::default(); outgoing.len()];
let from = Partition::new(&outgoing[..], &counts[..], displacements(&counts));
let mut into = PartitionMut::new(&mut incoming[..], &counts[..], displacements(&counts));
world.all_to_all_varcount_into(&from, &mut into);
incoming
