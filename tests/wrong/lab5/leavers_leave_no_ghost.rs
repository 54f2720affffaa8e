// region: 5.5
// fails: task_5_5_every_rank_gets_what_it_owns_and_what_it_sees, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: Only copies become ghosts. A particle that has just crossed is invisible to the rank that it left for one step.
for parcel in parcels {
    for leaver in &parcel.leavers {
        lists[cut.owner(row_of(leaver))].push(*leaver);
    }
    for wire in &parcel.copies {
        for neighbour in cut.neighbours(row_of(wire)) {
            lists[neighbour].push(*wire);
        }
    }
}
