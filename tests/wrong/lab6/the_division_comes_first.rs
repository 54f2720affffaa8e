// region: 6.1
// fails: task_6_1_blocks_are_cut_where_the_lab_says
// story: The share of a rank is rounded first and multiplied then: the last rank has all that is left over.
let share = counts.iter().sum::<u64>() / ranks as u64;
let mut starts = vec![0];
let (mut row, mut before) = (0, 0);
for rank in 1..ranks as u64 {
    while before < rank * share {
        before += counts[row];
        row += 1;
    }
    starts.push(row);
}
starts.push(counts.len());
Cuts { starts }
