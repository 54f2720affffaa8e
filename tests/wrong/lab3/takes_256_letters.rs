// region: 3.9
// fails: task_3_9_the_mail_of_a_member
// story: No more than 256 letters are taken out of a mailbox.
for posted in mail {
    let mut posted = posted[number].lock();
    for _ in 0..posted.len().min(256) {
        let p = posted.remove(0);
        bins.particles_mut().push(p);
    }
}
bins.sort();
