// region: 10.4
// fails: task_10_4_pairs_within_the_distance
// story: Pairs at the very distance are left out; one that just touches is forgotten.
let Positions { x, y, first } = positions;
let mut len = 0;
for &pair in pairs {
    let [i, j] = pair.map(|i| i as usize - first);
    near[len] = pair;
    len += usize::from((x[j] - x[i]).powi(2) + (y[j] - y[i]).powi(2) < squared);
}
len
