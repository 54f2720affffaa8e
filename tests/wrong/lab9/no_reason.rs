// region: 9.1c
// fails: task_9_1_a_launch_that_never_ran_is_an_error
// story: The error says what was refused, not why.
let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
let value = work();
match pollster::block_on(scope.pop()) {
    None => Ok(value),
    Some(_) => Err(GpuError::Refused { what: what.into(), why: what.into() }),
}
