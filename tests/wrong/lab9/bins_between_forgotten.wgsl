// region: 9.8
// fails: task_9_8_steps_in_single_precision
// story: Offsets are subtracted as if both particles were in one bin.
    return (sorted_positions[j] - sorted_positions[i]) * box.side;
