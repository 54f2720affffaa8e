// region: 11.4
// fails: task_11_4_two_may_be_off_their_paths, task_11_5_windows_have_the_bits_of_all_pairs
// story: It is never asked whether a push bent a path out of its margin: a third particle in the way is flown through.
let _ = (deviation, margin);
false
