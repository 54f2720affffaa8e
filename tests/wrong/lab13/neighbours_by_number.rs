// region: 13.2
// fails: task_13_2_partners_are_within_the_width
// loses: 13.8
// story: The partners are the ranks with the numbers next to one's own, however thin or empty their strips are.
let _ = width;
let ranks = strips.edges.len() - 1;
let beside = [rank.checked_sub(1), Some(rank + 1).filter(|after| *after < ranks)];
beside.into_iter().flatten().map(|other| other as Rank).collect()
