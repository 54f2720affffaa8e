// region: 6.7
// fails: task_6_7_a_share_is_what_lies_in_the_own_block
// story: The particles are counted by x, where blocks are cut by y: in a scene that is full at the bottom the cuts stand as if it were even.
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
