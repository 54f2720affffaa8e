// region: 9.8
// fails: task_9_8_steps_in_single_precision
// story: Both positions are made to count from the corner of the box before they are subtracted: the bits that the bins saved are lost.
    let bin = sorted_tags[i].x;
    let here = vec2<i32>(vec2<u32>(bin % box.columns, bin / box.columns));
    let from_ = (vec2<real>(here) + sorted_positions[i]) * box.side;
    let to = (vec2<real>(here + over) + sorted_positions[j]) * box.side;
    return to - from_;
