// region: 7.12
// fails: task_7_12_blocks_of_boxes
// story: Blocks are found in single precision.
for (blocks, first) in [(4.0, 0), (2.0, 16)] {
    let index = |at: f64| ((at as f32) / (side as f32) * (blocks as f32)).clamp(0.0, blocks as f32 - 1.0) as usize;
    if index(x.low) == index(x.high) && index(y.low) == index(y.high) {
        return first + blocks as usize * index(y.low) + index(x.low);
    }
}
20
