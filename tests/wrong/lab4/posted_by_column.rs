// region: 4.5
// fails: task_4_5_leavers_are_posted_to_their_owners
// story: The owner is looked up by the column instead of the row.
for particle in leavers {
    queues[owners[grid.column(particle.x)]].push(*particle);
}
