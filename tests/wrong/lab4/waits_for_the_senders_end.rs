// region: 4.8b
// fails: task_4_8_changes_are_sent_and_received, task_4_8_channels
// story: It receives until all senders are gone, and they live as long as the engine.
apply_own(cut, own, bins, receiver.iter());
