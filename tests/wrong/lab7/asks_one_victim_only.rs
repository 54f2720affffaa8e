// region: 7.10
// fails: task_7_10_own_parts_first_then_the_next_victim
// story: Only the next neighbour is asked. If that one has nothing, the worker waits though others have much.
own.pop().or_else(|| {
    let next = others.first()?;
    std::iter::repeat_with(|| next.steal()).find(|answer| !answer.is_retry())?.success()
})
