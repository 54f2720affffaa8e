// region: 4.10
// fails: task_4_10_every_pair_of_a_strip
// story: The size of a range is told in 8 bits.
let near = grid.near(column);
let here = bins.span(row, column..near.end);
let above = match bins.rows().contains(&(row + 1)) {
    true => bins.span(row + 1, near),
    false => 0..0,
};
for i in bins.span(row, column..column + 1) {
    let mut sum = Vec2::ZERO;
    for after in [i + 1..here.end, above.clone()] {
        observer.tested(u64::from(after.len() as u8));
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
