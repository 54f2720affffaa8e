// region: 9.7d
// fails: task_9_7_particles_stand_by_bin_and_by_id
// story: The counts of the step before stay: bins begin beyond the last particle.
        work.launch(&sort.count, sort.launch);
        Self::record_scan(&sort.scan, work);
        work.launch(&sort.scatter, sort.launch);
        work.launch(&sort.order, sort.launch);
