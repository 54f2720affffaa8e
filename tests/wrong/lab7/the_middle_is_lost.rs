// region: 7.10b
// fails: task_7_10_halves_lie_ready_the_largest_at_the_bottom, task_7_10_every_iteration_is_done_once
// story: The second half begins one behind the middle, as if ranges included their ends: an iteration of each cut belongs to no part.
let mut part = part;
while part.len() > least {
    let middle = part.start + part.len() / 2;
    own.push(middle + 1..part.end);
    part.end = middle;
}
part
