// region: 4.7
// fails: task_4_7_owners_empty_their_queues
// story: Regions are compared in 8 bits, so that one of two owners is not told.
let (from, _) = cut.find(change.from);
let (to, _) = cut.find(change.to);
queues[from].push(change);
if change.from != change.to && from as u8 != to as u8 {
    queues[to].push(change);
}
