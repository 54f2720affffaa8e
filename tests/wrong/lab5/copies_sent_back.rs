// region: 5.5
// fails: task_5_5_every_rank_gets_what_it_owns_and_what_it_sees, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// loses: 5.8
// story: Copies are handed to the owner of their row as well, which has them already: particles of border rows are doubled.
for parcel in parcels {
    for wire in parcel.leavers.iter().chain(&parcel.copies) {
        lists[cut.owner(row_of(wire))].push(*wire);
        for neighbour in cut.neighbours(row_of(wire)) {
            lists[neighbour].push(*wire);
        }
    }
}
