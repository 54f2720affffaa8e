// region: 5.5
// fails: task_5_5_every_rank_gets_what_it_owns_and_what_it_sees
// story: Ghosts go to the ranks whose numbers are one less and one more. Where ranks outnumber rows, the neighbouring row's owner is another one.
for parcel in parcels {
    for leaver in &parcel.leavers {
        lists[cut.owner(row_of(leaver))].push(*leaver);
    }
    for wire in parcel.leavers.iter().chain(&parcel.copies) {
        let row = row_of(wire);
        let owner = cut.owner(row);
        let block = cut.block(owner);
        if row == block.start && row > 0 {
            lists[owner - 1].push(*wire);
        }
        if row + 1 == block.end && row + 1 < cut.rows {
            lists[owner + 1].push(*wire);
        }
    }
}
