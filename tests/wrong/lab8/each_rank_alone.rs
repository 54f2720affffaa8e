// region: 8.10
// fails: task_8_10_what_is_certain_is_taken, task_8_11_ranks_together_take_what_one_would, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: Each rank takes its own candidates in their order and asks no other rank: a disc near a cut collides on both sides of it.
decisions.front.clear();
for local in decisions.queues.all() {
    let candidate = decisions.named(local);
    if decisions.slots(&candidate).all(|slot| decisions.free[slot]) {
        decisions.slots(&candidate).for_each(|slot| decisions.free[slot] = false);
        decisions.taken.push(candidate);
    }
}
