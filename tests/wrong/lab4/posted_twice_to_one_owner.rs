// region: 4.7
// fails: task_4_7_owners_empty_their_queues, task_4_7_queues
// story: An owner of both bins gets the change twice, and finds the particle gone at the second time.
let (from, _) = cut.find(change.from);
let (to, _) = cut.find(change.to);
queues[from].push(change);
queues[to].push(change);
