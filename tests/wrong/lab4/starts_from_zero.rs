// region: 4.10
// fails: task_4_10_every_pair_of_a_strip
// story: Accelerations are set to zero first, where they should be added to.
let near = grid.near(column);
let here = bins.span(row, column..near.end);
let above = match bins.rows().contains(&(row + 1)) {
    true => bins.span(row + 1, near),
    false => 0..0,
};
if row == bins.rows().start && column == 0 {
    accelerations.fill(Vec2::ZERO);
}
for i in bins.span(row, column..column + 1) {
    let mut sum = Vec2::ZERO;
    for after in [i + 1..here.end, above.clone()] {
        observer.tested(after.len() as u64);
        for j in after {
            let d = particles[i].to(&particles[j]);
            if let Some(a) = pair_acceleration(d) {
                sum += a;
                accelerations[j] -= a;
                observer.seen(d.norm_squared());
                observer.seen(d.norm_squared());
            }
        }
    }
    accelerations[i] += sum;
}
