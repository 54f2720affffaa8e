// region: 4.11
// fails: task_4_11_the_pair_across_a_cut_counts_once
// story: A pair across the cut is seen once only.
let there = next.span(above, grid.near(column));
for i in bins.span(row, column..column + 1) {
    observer.tested(there.len() as u64);
    for k in there.clone() {
        let d = bins.particles()[i].to(&next.particles()[k]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            across[k] = across[k] - a;
            observer.seen(d.norm_squared());
        }
    }
}
