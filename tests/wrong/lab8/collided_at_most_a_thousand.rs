// region: 8.6
// fails: task_8_6_workers_are_told_which_discs_collided
// story: At most a thousand are sent.
let involved = taken.iter().flat_map(|c| [Some(c.hit.first()), c.hit.second()]).flatten();
involved
    .map(|number| number as usize)
    .filter(|&number| held.contains(&blocks.owner(number)))
    .map(|number| DiscWire::new(number, &discs[number]))
    .take(1000)
    .collect()
