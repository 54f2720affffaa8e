// region: 3.7
// fails: task_3_7_arrivals_of_a_crew_member, task_3_8_the_crew
// story: The mail is read and not taken out: it arrives again in every step.
for posted in mail {
    bins.particles_mut().extend(posted[number].lock().iter().copied());
}
bins.sort();
