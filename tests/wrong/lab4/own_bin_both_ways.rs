// region: 4.10
// fails: task_4_10_every_pair_of_a_strip, task_4_11_owners_with_two_way_forces
// story: In the own bin each particle looks at all: those pairs count twice.
let near = grid.near(column);
let here = bins.span(row, column..near.end);
let above = match bins.rows().contains(&(row + 1)) {
    true => bins.span(row + 1, near),
    false => 0..0,
};
for i in bins.span(row, column..column + 1) {
    observer.tested((here.len() - 1 + above.len()) as u64);
    for j in here.clone().chain(above.clone()).filter(|j| *j != i) {
        let d = particles[i].to(&particles[j]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            accelerations[j] -= a;
            observer.seen(d.norm_squared());
            observer.seen(d.norm_squared());
        }
    }
}
