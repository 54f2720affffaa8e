// region: 6.1
// fails: task_6_1_blocks_are_cut_where_the_lab_says
// story: The product of rank and particles is a u64: with 2^62 particles in all and 8 ranks it overflows.
let all: u64 = counts.iter().sum();
let mut starts = vec![0];
let (mut row, mut before) = (0, 0);
for rank in 1..ranks as u64 {
    let share = rank.wrapping_mul(all) / ranks as u64;
    while before < share {
        before += counts[row];
        row += 1;
    }
    starts.push(row);
}
starts.push(counts.len());
Cuts { starts }
