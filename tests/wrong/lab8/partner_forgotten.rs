// region: 8.6
// fails: task_8_6_workers_are_told_which_discs_collided, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: Of each pair only the first disc is sent to the workers that have it; the second keeps its old velocity there.
taken
    .iter()
    .map(|candidate| candidate.hit.first() as usize)
    .filter(|&number| held.contains(&blocks.owner(number)))
    .map(|number| DiscWire::new(number, &discs[number]))
    .collect()
