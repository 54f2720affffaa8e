// region: 4.10
// fails: task_4_10_every_pair_of_a_strip, task_4_11_owners_with_two_way_forces
// story: Above there are only the bin straight above and the one to the right of it. Pairs across the upper left corner are missed.
let near = grid.near(column);
let here = bins.span(row, column..near.end);
let above = match bins.rows().contains(&(row + 1)) {
    true => bins.span(row + 1, column..near.end),
    false => 0..0,
};
for i in bins.span(row, column..column + 1) {
    observer.tested((here.end - i - 1 + above.len()) as u64);
    for j in (i + 1..here.end).chain(above.clone()) {
        let d = particles[i].to(&particles[j]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            accelerations[j] -= a;
            observer.seen(d.norm_squared());
            observer.seen(d.norm_squared());
        }
    }
}
