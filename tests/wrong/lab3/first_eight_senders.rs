// region: 3.9
// fails: task_3_9_the_mail_of_a_member, task_3_11_the_team
// story: Only the mail of the first eight members is taken.
for posted in mail.iter().take(8) {
    bins.particles_mut().append(&mut posted[number].lock());
}
bins.sort();
