// region: 4.8
// fails: task_4_8_changes_are_sent_and_received, task_4_8_channels
// story: Only the owner of the old bin hears of it: the particle is in no bin from now on.
let (from, _) = cut.find(change.from);
senders[from].send(change).expect("the receiver lives as long as the engine");
