// region: 3.9
// fails: task_3_9_the_mail_of_a_member, task_3_11_the_team
// story: The bins are sorted only if mail came, and particles that moved within the own rows stay in their old bins.
let before = bins.particles().len();
for posted in mail {
    bins.particles_mut().append(&mut posted[number].lock());
}
if bins.particles().len() > before {
    bins.sort();
}
