// region: 3.9
// fails: task_3_9_the_mail_of_a_member
// story: An empty mailbox is taken for the last one.
for posted in mail {
    let mut posted = posted[number].lock();
    if posted.is_empty() {
        break;
    }
    bins.particles_mut().append(&mut posted);
}
bins.sort();
