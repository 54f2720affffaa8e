// region: 10.8
// fails: task_10_8_two_may_be_off_their_paths, task_10_6_windows_have_the_bits_of_all_pairs
// story: Nobody asks whether a push bent a path out of its margin: a third particle in the way is flown through.
let _ = (bent, margin);
false
