// region: 9.7d
// fails: task_9_7_particles_stand_by_bin_and_by_id
// story: The counts of the step before stay: bins begin beyond the last particle.
        work.launch(&self.count, self.launch);
        self.scan.record(work);
        work.launch(&self.scatter, self.launch);
        work.launch(&self.order, self.launch);
