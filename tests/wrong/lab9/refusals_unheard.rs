// region: 9.1c
// fails: task_9_1_a_launch_that_never_ran_is_an_error
// story: Errors are caught and thrown away, as in the report: its best-looking row came from a launch that never ran.
    let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
    let value = work();
    let _ = (what, pollster::block_on(scope.pop()));
    Ok(value)
