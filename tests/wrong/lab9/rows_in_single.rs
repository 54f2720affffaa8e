// region: 9.1
// fails: task_9_1_launches_within_the_limits
// story: The rows are divided in single precision: some large launches get a row too few.
if blocks == 0 || threads == 0 {
    return Err(LaunchError::Nothing { blocks, threads });
}
let most =
    limits.max_compute_invocations_per_workgroup.min(limits.max_compute_workgroup_size_x);
if threads > most {
    return Err(LaunchError::Threads { threads, most });
}
let most = limits.max_compute_workgroups_per_dimension;
let rows = (blocks as f32 / most as f32).ceil() as u32;
if rows > most {
    return Err(LaunchError::Blocks { blocks, most });
}
Ok(Launch { groups: [blocks.div_ceil(rows), rows], threads })
