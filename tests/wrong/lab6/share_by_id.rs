// region: 6.7
// fails: task_6_7_the_bits_of_all_pairs_in_a_dense_box, task_6_7_a_scene_that_each_rank_makes_for_itself
// story: The particles are dealt by their ids, an equal number to each rank, and not by the rows they stand in: ranks get particles that lie outside their blocks.
let mut counts = vec![0; grid.rows()];
replay(&mut |particle| counts[grid.row(particle.y)] += 1);
let cuts = balanced(&counts, ranks);
let all = counts.iter().sum::<u64>() as usize;
let mut share = Vec::new();
replay(&mut |particle| {
    if particle.id as usize * ranks / all == rank {
        share.push(particle);
    }
});
(cuts, share)
