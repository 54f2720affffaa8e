// region: 8.11
// fails: task_8_11_partners_hear_what_concerns_them, task_8_11_ranks_together_take_what_one_would, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: What has been taken is no longer open, so no partner hears of it, and there the disc is still free.
decisions.front.iter().filter(|candidate| decisions.concerns(candidate, partner)).map(CandidateWire::from).collect()
