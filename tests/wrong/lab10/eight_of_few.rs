// region: 10.2
// fails: task_10_2_lists_exactly_the_pairs_within_reach
// loses: 10.5, 10.6
// story: Eight are compared where the range has fewer, and those behind its end are listed too; some of them are listed twice.
let (xi, yi) = (positions.x[i], positions.y[i]);
let (mut len, mut start) = (len, range.start);
while start < range.end {
    let (x, y) = positions.eight(start);
    let mut spare = [0.0; EIGHT];
    for l in 0..EIGHT {
        let (dx, dy) = (x[l] - xi, y[l] - yi);
        spare[l] = (reach * reach - (dx * dx + dy * dy)) as f32;
    }
    len = pack(list, len, [i, start], !signs.negative(&spare));
    start += EIGHT;
}
len
