// region: 7.10b
// fails: task_7_10_halves_lie_ready_the_largest_at_the_bottom
// story: The part is cut from its far end, a chunk at a time: a thief gets a chunk instead of half of all, and must come back for each.
let mut part = part;
while part.len() > least {
    let middle = part.end - least;
    own.push(middle..part.end);
    part.end = middle;
}
part
