// region: 9.4b
// fails: task_9_4_every_pair_has_a_number
// story: The pair's number is one u32: with 100,000 discs it starts again at zero, and late rows meet early pairs.
    if square.n < 2u {
        return;
    }
    let last = min(square.last, rows());
    let pairs = (last - square.first) * width();
    for (var k = me; k < pairs; k += all) {
        let number = square.first * width() + k;
        let pair = pair_at(number / width(), number % width());
        if may_meet(pair.x, pair.y) {
            append(pair.x, pair.y);
        }
    }
