// region: 9.1
// fails: task_9_1_launches_within_the_limits
// story: The launch is taken as asked for, whatever the device can count to.
        if blocks == 0 || threads == 0 {
            return Err(LaunchError::Nothing { blocks, threads });
        }
        let most = limits.max_compute_invocations_per_workgroup;
        if threads > most {
            return Err(LaunchError::Threads { threads, most });
        }
        Ok(Launch { groups: [blocks, 1], threads })
