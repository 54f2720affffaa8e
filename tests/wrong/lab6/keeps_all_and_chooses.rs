// region: 6.7
// fails: task_6_7_a_share_is_what_lies_in_the_own_block
// story: The scene is replayed once, into a list of all particles, from which the rank chooses its own: no rank has room for it.
let mut all = Vec::new();
replay(&mut |particle| all.push(particle));
let mut counts = vec![0; grid.rows()];
for particle in &all {
    counts[grid.row(particle.y)] += 1;
}
let cuts = balanced(&counts, ranks);
let block = cuts.block(rank);
let share = all.into_iter().filter(|particle| block.contains(&grid.row(particle.y))).collect();
(cuts, share)
