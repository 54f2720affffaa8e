// region: 10.2
// fails: task_10_2_at_reach_is_within
// story: Distances are squared in single precision, which has seven digits: a pair that is just within reach may be lost.
let (xi, yi) = (positions.x[i], positions.y[i]);
let (mut len, mut start) = (len, range.start);
while start < range.end {
    let (x, y) = positions.eight(start);
    let in_range = (1 << (range.end - start).min(EIGHT)) - 1;
    let mut spare = [0.0; EIGHT];
    for l in 0..EIGHT {
        let (dx, dy) = ((x[l] - xi) as f32, (y[l] - yi) as f32);
        spare[l] = (reach * reach) as f32 - (dx * dx + dy * dy);
    }
    len = pack(list, len, [i, start], in_range & !signs.negative(&spare));
    start += EIGHT;
}
len
