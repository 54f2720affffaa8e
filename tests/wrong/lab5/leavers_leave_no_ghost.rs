// region: 5.5
// fails: task_5_5_leavers_in_a_border_row_are_ghosts_of_the_neighbour, task_5_8_the_bits_of_all_pairs_in_a_dense_box
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
