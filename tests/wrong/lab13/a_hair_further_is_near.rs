// region: 13.2
// fails: task_13_2_partners_are_within_the_width
// story: A strip a hair further than the width is a partner too.
let own = strips.strip(rank);
let is_partner = |other: &usize| {
    let strip = strips.strip(*other);
    *other != rank
        && !own.is_empty()
        && !strip.is_empty()
        && strip.start - own.end <= width * (1.0 + 1e-12)
        && own.start - strip.end <= width * (1.0 + 1e-12)
};
(0..strips.ranks()).filter(is_partner).map(|other| other as Rank).collect()
