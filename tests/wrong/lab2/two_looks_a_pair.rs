// region: 2.7b
// fails: task_2_7_each_pair_is_looked_at_once
// story: Each pair is told twice, as if both had looked.
let Self { particles, accelerations, lists, observer, .. } = self;
let mut push_both = |i: usize, j: usize| {
    let d = particles[i].to(&particles[j]);
    observer.tested(2);
    if let Some(a) = pair_acceleration(d) {
        accelerations[i] += a;
        accelerations[j] -= a;
        observer.seen(d.norm_squared());
        observer.seen(d.norm_squared());
    }
};
for i in lists.bin(bin) {
    for j in lists.after(i) {
        push_both(i, j);
    }
    for next in ahead {
        for j in lists.bin(*next) {
            push_both(i, j);
        }
    }
}
