// region: 4.11
// fails: task_4_11_the_pair_across_a_cut_counts_once, task_4_11_owners_with_two_way_forces
// story: The next owner's share is not written anywhere, since one may not write there.
let there = next.span(above, grid.near(column));
for i in bins.span(row, column..column + 1) {
    for k in there.clone() {
        let d = bins.particles()[i].to(&next.particles()[k]);
        if let Some(a) = pair_acceleration(d) {
            accelerations[i] += a;
            observer.seen(d.norm_squared());
            observer.seen(d.norm_squared());
        }
    }
}
let _ = &across;
