// region: 8.6
// fails: task_8_6_workers_are_told_which_discs_collided, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: A worker is told of its own block only. In its other blocks discs that have collided fly straight on.
let involved = taken.iter().flat_map(|c| [Some(c.hit.first()), c.hit.second()]).flatten();
involved
    .map(|number| number as usize)
    .filter(|&number| held.first() == Some(&blocks.owner(number)))
    .map(|number| DiscWire::new(number, &discs[number]))
    .collect()
