// region: 7.4b
// fails: task_7_4_a_disc_is_taken_once, task_7_4_takes_the_earliest_first, task_7_7_twenty_steps_of_twenty_scenes
// story: A candidate that cannot happen takes its other disc out of the step all the same.
let first = candidate.hit.first() as usize;
let second = candidate.hit.second().map_or(first, |b| b as usize);
let happens = free[first] && free[second];
free[first] = false;
free[second] = false;
if happens {
    taken.push(*candidate);
}
