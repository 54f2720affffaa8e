// region: 7.10
// fails: task_7_10_own_parts_first_then_the_next_victim
// story: A worker steals as long as there is something to steal and only then does its own parts: all workers are in each other's deques all the time.
let ask_all = || others.iter().map(Victim::steal).collect::<Steal<_>>();
let stolen = std::iter::repeat_with(ask_all).find(|answer| !answer.is_retry())?.success();
stolen.or_else(|| own.pop())
