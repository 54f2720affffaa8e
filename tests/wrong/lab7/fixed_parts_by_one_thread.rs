// region: 7.9
// fails: task_7_9_no_thread_does_the_work_of_the_others
// story: The fixed parts are known before the loop starts, so one thread goes through all of them. Each pair comes into the right list.
match schedule {
    Schedule::Static => {
        for worker in 0..team.count() {
            for a in crate::fixed_part(n, team.count(), worker) {
                look(worker, a, a + 1..n);
            }
        }
    }
    Schedule::Dynamic { .. } => parallel_for(n, team, schedule, |worker, part| {
        for a in part {
            look(worker, a, a + 1..n);
        }
    }),
}
