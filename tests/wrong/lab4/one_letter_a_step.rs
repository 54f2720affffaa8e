// region: 4.5b
// fails: task_4_5_an_owner_empties_its_queue, task_4_5_queues
// story: One particle is taken from the queue in a step. The others wait there and feel nothing.
if let Some(particle) = queue.pop() {
    own[grid.bin(&particle) - first_bin].push(particle);
}
