// region: 7.12
// fails: task_7_12_blocks_of_boxes
// story: A box that ends exactly on an edge stays below it.
for (blocks, first) in [(4.0, 0), (2.0, 16)] {
    let index = |at: f64| (at / side * blocks).clamp(0.0, blocks - 1.0) as usize;
    if index(x.low) == index(x.high.next_down()) && index(y.low) == index(y.high.next_down()) {
        return first + blocks as usize * index(y.low) + index(x.low);
    }
}
20
