// region: 6.7
// fails: task_6_7_a_share_is_what_lies_in_the_own_block
// story: The rows are cut evenly, and nothing is counted. The result is right; the balance is not, for fifty steps.
let rows = grid.rows();
let cuts = Cuts { starts: (0..=ranks).map(|rank| rank * rows / ranks).collect() };
let block = cuts.block(rank);
let mut share = Vec::new();
replay(&mut |particle| {
    if block.contains(&grid.row(particle.y)) {
        share.push(particle);
    }
});
(cuts, share)
