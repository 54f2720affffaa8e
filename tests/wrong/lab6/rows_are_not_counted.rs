// region: 6.7
// fails: task_6_7_a_share_is_what_lies_in_the_own_block
// story: The rows are cut evenly, whatever lies in them: no rank counts the particles. Where all rows are equally full nobody notices.
let counts = vec![1; grid.rows()];
let cuts = balanced(&counts, ranks);
let block = cuts.block(rank);
let mut share = Vec::new();
replay(&mut |particle| {
    if block.contains(&grid.row(particle.y)) {
        share.push(particle);
    }
});
(cuts, share)
