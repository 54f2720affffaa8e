// region: 6.6
// fails: task_6_6_leavers_go_to_neighbours_or_further, task_6_7_particles_that_cross_several_ranks_in_a_step
// loses: 6.7
// story: A particle that leaves upwards goes to the neighbour above, however far it flies.
let _ = Leavers::default();
for leaver in leavers {
    let owner = cuts.owner(grid.row(leaver.y));
    match neighbours {
        [Some(before), _] if owner <= before => sorted.near[0].push(*leaver),
        [_, Some(after)] if owner >= after => sorted.near[1].push(*leaver),
        _ => sorted.far.push((owner, *leaver)),
    }
}
