// region: 10.3b
// fails: task_10_3_no_other_skin_is_cheaper
// loses: 10.6
// story: Every pair is charged to both of its particles, as if it stood in two lists: the skin is too thin.
let cost = |skin: f64| {
    let area = (CUTOFF + skin) * (CUTOFF + skin);
    let rebuilds = (2.0 * displacement / skin).min(1.0);
    rebuilds * (REBUILD + TESTED * 9.0 * area * density) + LISTED * PI * area * density
};
(1..=60)
    .map(|twentieths| f64::from(twentieths) * 0.05 * CUTOFF)
    .min_by(|&a, &b| cost(a).total_cmp(&cost(b)))
    .unwrap_or(CUTOFF)
