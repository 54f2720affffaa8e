// region: 10.6
// fails: task_10_6_accelerations_of_both_particles
// story: Forces are computed for the pairs of the outer list: right, and the inner list saves nothing.
let Self { bodies, outer, contacts, ax, ay, observer, .. } = self;
for sums in [&mut *ax, &mut *ay] {
    sums.clear();
    sums.resize(bodies.len(), 0.0);
}
contacts.for_each(&outer.pairs, bodies.positions(), |[i, j], [x, y], r2| {
    let (i, j) = (i as usize, j as usize);
    (ax[i], ay[i]) = (ax[i] + x, ay[i] + y);
    (ax[j], ay[j]) = (ax[j] - x, ay[j] - y);
    observer.seen(r2);
    observer.seen(r2);
});
