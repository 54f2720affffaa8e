// region: 10.5
// fails: task_10_5_at_the_distance_is_near
// story: Pairs at the very distance are left out; one that just touches is forgotten.
let Places { x, y, first } = places;
let mut len = 0;
for &pair in pairs {
    let [i, j] = pair.map(|i| i as usize - first);
    near[len] = pair;
    len += usize::from((x[j] - x[i]).powi(2) + (y[j] - y[i]).powi(2) < squared);
}
len
