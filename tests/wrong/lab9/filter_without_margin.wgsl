// region: 9.2
// fails: task_9_2_no_pair_is_lost_in_single_precision
// story: Receding is asked of rounded numbers without a margin: pairs that close in slowly are lost in f32.
    let d = discs[b].xy - discs[a].xy;
    let velocity = discs[b].zw - discs[a].zw;
    let s = dot(d, velocity);
    let speed_squared = dot(velocity, velocity);
    var t = real(0.0);
    if speed_squared > 0.0 {
        t = clamp(-s / speed_squared, 0.0, 1.0);
    }
    let nearest = d + t * velocity;
    let near = dot(nearest, nearest) <= square.reach_squared && s < 0.0;
    return near || square.everything != 0u;
