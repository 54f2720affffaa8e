// region: 7.3
// fails: task_7_3_the_order_of_candidates, task_7_7_twenty_steps_of_twenty_scenes
// loses: 7.4, 7.7
// story: Candidates are taken in the order of their discs' numbers, as the loops find them, and not in the order of time.
(a.hit.first(), a.hit.second()).cmp(&(b.hit.first(), b.hit.second()))
