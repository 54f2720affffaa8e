// region: 9.4b
// fails: task_9_4_invocations_share_the_pairs
// story: The first invocation goes through all pairs, and the others do nothing.
    if square.n < 2u || me > 0u {
        return;
    }
    for (var row = square.first; row < min(square.last, rows()); row++) {
        for (var column = 0u; column < width(); column++) {
            let pair = pair_at(row, column);
            if may_meet(pair.x, pair.y) {
                append(pair.x, pair.y);
            }
        }
    }
