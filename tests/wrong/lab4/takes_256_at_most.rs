// region: 4.7b
// fails: task_4_7_owners_empty_their_queues
// story: No more than 256 changes are taken from the queue.
let mut left = 256;
apply_own(
    cut,
    own,
    bins,
    std::iter::from_fn(|| {
        if left == 0 {
            return None;
        }
        left -= 1;
        queue.pop()
    }),
);
