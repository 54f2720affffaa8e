// region: 13.2
// fails: task_13_2_partners_are_within_the_width
// story: Ranks above 127 are no partners.
let own = strips.strip(rank);
let is_partner = |other: &usize| {
    let strip = strips.strip(*other);
    *other != rank
        && !own.is_empty()
        && !strip.is_empty()
        && strip.start - own.end <= width
        && own.start - strip.end <= width
};
(0..strips.ranks().min(128)).filter(is_partner).map(|other| other as Rank).collect()
