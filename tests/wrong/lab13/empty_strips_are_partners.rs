// region: 13.2
// fails: task_13_2_partners_are_within_the_width
// story: A rank without a strip gets ghosts that it has no use for. The result is right.
let own = strips.strip(rank);
let is_partner = |other: &usize| {
    let strip = strips.strip(*other);
    *other != rank && strip.start - own.end <= width && own.start - strip.end <= width
};
(0..strips.ranks()).filter(is_partner).map(|other| other as Rank).collect()
