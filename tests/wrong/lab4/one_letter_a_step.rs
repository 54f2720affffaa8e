// region: 4.7b
// fails: task_4_7_owners_empty_their_queues, task_4_7_queues
// story: One change is taken from the queue in a step. The others wait there.
apply_own(cut, own, bins, queue.pop().into_iter());
