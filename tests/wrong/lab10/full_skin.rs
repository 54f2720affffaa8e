// region: 10.3
// fails: task_10_3_both_of_a_pair_move, task_10_5_two_meet_across_a_worn_skin
// story: The list is rebuilt when one particle has flown the whole skin; two that fly towards each other meet before.
moved_squared > skin * skin
