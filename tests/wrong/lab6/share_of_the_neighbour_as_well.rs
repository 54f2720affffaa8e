// region: 6.7
// fails: task_6_7_the_bits_of_all_pairs_in_a_dense_box
// story: Each rank keeps the first row of the next block as well: its particles are there twice, and are counted in the wrong bins.
let mut counts = vec![0; grid.rows()];
replay(&mut |particle| counts[grid.row(particle.y)] += 1);
let cuts = balanced(&counts, ranks);
let block = cuts.block(rank);
let mut share = Vec::new();
replay(&mut |particle| {
    if block.start <= grid.row(particle.y) && grid.row(particle.y) <= block.end {
        share.push(particle);
    }
});
(cuts, share)
