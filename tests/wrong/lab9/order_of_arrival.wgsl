// region: 9.7c
// fails: task_9_7_particles_stand_by_bin_and_by_id
// story: Particles stand in the order of their arrival, which is the device's, not ours: a second run sums in another order.
    if i < box.n {
        let tag = tags[i];
        var to = starts[tag.x];
        while slots[to] != i {
            to++;
        }
        sorted_tags[to] = tag;
        sorted_positions[to] = positions[i];
        sorted_velocities[to] = velocities[i];
    }
