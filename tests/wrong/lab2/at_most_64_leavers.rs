// region: 2.5
// fails: task_2_5_leavers_are_taken_out_and_the_rest_stay
// story: From the 65th on those that have left a bin stay in it.
let mut i = 0;
let mut left = 0;
while i < inside.len() {
    if grid.bin(&inside[i]) == bin || left == 64 {
        i += 1;
    } else {
        changed.push(inside.swap_remove(i));
        left += 1;
    }
}
