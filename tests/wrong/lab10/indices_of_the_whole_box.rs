// region: 10.4
// fails: task_10_4_pairs_within_the_distance
// story: Pairs are looked up from the first particle of all, not from the first of these.
let Positions { x, y, .. } = positions;
let mut len = 0;
for &pair in pairs {
    let [i, j] = pair.map(|i| i as usize % x.len());
    let (dx, dy) = (x[j] - x[i], y[j] - y[i]);
    near[len] = pair;
    len += usize::from(dx * dx + dy * dy <= squared);
}
len
