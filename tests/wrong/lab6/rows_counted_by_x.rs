// region: 6.7
// fails: task_6_7_a_share_is_what_lies_in_the_own_block
// story: The row is taken from x. The result is right; the balance is that of the scene on its side.
let mut counts = vec![0; grid.rows()];
replay(&mut |particle| counts[grid.row(particle.x)] += 1);
let cuts = balanced(&counts, ranks);
let block = cuts.block(rank);
let mut share = Vec::new();
replay(&mut |particle| {
    if block.contains(&grid.row(particle.y)) {
        share.push(particle);
    }
});
(cuts, share)
