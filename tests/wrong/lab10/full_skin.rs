// region: 10.3
// fails: task_10_3_both_of_a_pair_move, task_10_6_two_meet_after_half_a_skin_each
// loses: 10.6
// story: The list is rebuilt when one particle has flown the whole skin; two that fly towards each other meet before.
displacement > skin
