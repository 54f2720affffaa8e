// region: 3.9
// fails: task_3_9_the_mail_of_a_member, task_3_11_the_team
// story: The mail is read and not taken out: it arrives again in every step.
for posted in mail {
    bins.particles_mut().extend(posted[number].lock().iter().copied());
}
bins.sort();
