// region: 10.2
// fails: task_10_2_at_reach_is_within
// story: Those are taken whose distance is less than the reach; a pair at the reach itself is left out.
let (xi, yi) = (positions.x[i], positions.y[i]);
let (mut len, mut start) = (len, range.start);
while start < range.end {
    let (x, y) = positions.eight(start);
    let in_range = (1 << (range.end - start).min(EIGHT)) - 1;
    let mut over = [0.0; EIGHT];
    for l in 0..EIGHT {
        let (dx, dy) = (x[l] - xi, y[l] - yi);
        over[l] = (dx * dx + dy * dy - reach * reach) as f32;
    }
    len = pack(list, len, [i, start], in_range & signs.negative(&over));
    start += EIGHT;
}
len
