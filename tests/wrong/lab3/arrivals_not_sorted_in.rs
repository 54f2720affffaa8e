// region: 3.7
// fails: task_3_7_arrivals_of_a_crew_member
// story: The arrivals stand behind the last bin, where nobody looks.
bins.sort();
for posted in mail {
    bins.particles_mut().append(&mut posted[number].lock());
}
