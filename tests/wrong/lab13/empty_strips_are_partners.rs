// region: 13.2
// fails: task_13_2_partners_are_within_the_width
// story: A rank without a strip gets ghosts that it has no use for. The result is right.
let own = self.strip(rank);
let is_partner = |other: &usize| {
    let strip = self.strip(*other);
    *other != rank && strip.start - own.end <= width && own.start - strip.end <= width
};
(0..self.edges.len() - 1).filter(is_partner).map(|other| other as Rank).collect()
