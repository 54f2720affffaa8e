// region: 10.6
// fails: task_10_6_accelerations_of_both_particles
// story: A pair stands in the list once, and only its first particle is accelerated.
let Self { bodies, inner, contacts, ax, ay, observer, .. } = self;
for sums in [&mut *ax, &mut *ay] {
    sums.clear();
    sums.resize(bodies.len(), 0.0);
}
contacts.for_each(&inner.pairs, bodies.positions(), |[i, j], [x, y], r2| {
    let (i, j) = (i as usize, j as usize);
    (ax[i], ay[i]) = (ax[i] + x, ay[i] + y);
    let _ = j;
    observer.seen(r2);
    observer.seen(r2);
});
