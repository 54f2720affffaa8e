// region: 6.1
// fails: task_6_1_blocks_are_cut_where_the_lab_says
// story: The number of all particles in 32 bits: more than four thousand million do not fit.
let all: u32 = counts.iter().map(|count| *count as u32).fold(0, u32::wrapping_add);
let mut starts = vec![0];
let (mut row, mut before) = (0, 0);
for rank in 1..ranks as u64 {
    let share = rank * u64::from(all) / ranks as u64;
    while before < share {
        before += counts[row];
        row += 1;
    }
    starts.push(row);
}
starts.push(counts.len());
Cuts { starts }
