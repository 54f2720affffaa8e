// region: 5.5
// fails: task_5_5_every_rank_gets_what_it_owns_and_what_it_sees, task_5_8_particles_that_cross_several_ranks_in_a_step
// loses: 5.8
// story: A leaver goes to the rank beside the one it left, as if no particle could cross a whole block in one step.
for (from, parcel) in parcels.iter().enumerate() {
    for leaver in &parcel.leavers {
        let owner = cut.owner(row_of(leaver));
        lists[owner.clamp(from.saturating_sub(1), from + 1)].push(*leaver);
    }
    for wire in parcel.leavers.iter().chain(&parcel.copies) {
        for neighbour in cut.neighbours(row_of(wire)) {
            lists[neighbour].push(*wire);
        }
    }
}
