// region: 10.2
// fails: task_10_2_lists_exactly_the_pairs_within_reach
// loses: 10.5, 10.6
// story: Neighbours are numbered from the beginning of the range, not of the order.
let mut len = len;
for (k, j) in range.enumerate() {
    let ((x, y), (xi, yi)) = ((positions.x[j], positions.y[j]), (positions.x[i], positions.y[i]));
    let (dx, dy) = (x - xi, y - yi);
    let far = signs.negative(&[(reach * reach - (dx * dx + dy * dy)) as f32; EIGHT]);
    len = pack(list, len, [i, k], !far & 1);
}
len
