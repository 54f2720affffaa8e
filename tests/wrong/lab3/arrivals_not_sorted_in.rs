// region: 3.9
// fails: task_3_9_the_mail_of_a_member
// story: The arrivals stand behind the last bin, where no thread looks.
bins.sort();
for posted in mail {
    bins.particles_mut().append(&mut posted[number].lock());
}
