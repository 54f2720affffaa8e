// region: 7.4b
// fails: task_7_4_takes_the_earliest_first, task_7_7_twenty_steps_of_twenty_scenes
// story: Only the first disc must be free, so a disc collides twice in a step.
let first = candidate.hit.first() as usize;
let second = candidate.hit.second().map_or(first, |b| b as usize);
if free[first] {
    free[first] = false;
    free[second] = false;
    taken.push(*candidate);
}
