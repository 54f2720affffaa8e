// region: 4.11
// fails: task_4_11_the_pair_across_a_cut_counts_once
// story: The size of a range is told in 8 bits.
let there = next.span(above, grid.near(column));
for i in bins.span(row, column..column + 1) {
    observer.tested(u64::from(there.len() as u8));
    for k in there.clone() {
        let d = bins.particles()[i].to(&next.particles()[k]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            across[k] -= a;
            observer.seen(d.norm_squared());
            observer.seen(d.norm_squared());
        }
    }
}
