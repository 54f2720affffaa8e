// region: 4.11
// fails: task_4_11_the_pair_across_a_cut_counts_once, task_4_11_owners_with_two_way_forces
// story: Across the cut both are pushed in the same direction.
let there = next.span(above, grid.near(column));
for i in bins.span(row, column..column + 1) {
    observer.tested(there.len() as u64);
    for k in there.clone() {
        let d = bins.particles()[i].to(&next.particles()[k]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            across[k] += a;
            observer.seen(d.norm_squared());
            observer.seen(d.norm_squared());
        }
    }
}
