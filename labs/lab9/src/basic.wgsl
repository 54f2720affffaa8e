// Task 9.3: the basic version.
//
// This is the report's find_collisions. Invocation t of T takes the discs t, t + T, t + 2T, … of
// its launch. For each disc, it tests the walls and all discs after it.

// Appends all candidates of the discs i, square.first <= i < square.last.
//
// They are (i, WALL) if the disc may hit a wall, and (i, j) for each disc j > i that it may meet.
// `me` is the number of this invocation, and `all` is the number of invocations.
fn find_of_discs(me: u32, all: u32) {
    // todo: task 9.3: every disc and all discs after it
}

@compute @workgroup_size(THREADS)
fn find_collisions(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    find_of_discs(invocation(id, groups), invocations(groups));
}
