// region: 4.7
// fails: task_4_7_owners_empty_their_queues, task_4_7_queues
// story: Only the owner of the new bin hears of it: in the old bin the particle stays.
let (to, _) = cut.find(change.to);
queues[to].push(change);
