// region: 7.3
// fails: task_7_3_the_order_of_candidates
// loses: 7.4
// story: Times that differ by less than 1e-10 count as the same. The report's GPU program does that, because its zeros came out as 1e-16.
if (a.time - b.time).abs() < 1e-10 {
    return a.hit.cmp(&b.hit);
}
a.time.partial_cmp(&b.time).expect("no time is NaN")
