// region: 4.8b
// fails: task_4_8_changes_are_sent_and_received
// story: No more than 256 changes are received.
apply_own(cut, own, bins, receiver.try_iter().take(256));
