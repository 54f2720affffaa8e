// region: 10.2
// fails: task_10_2_lists_exactly_those_within_reach
// story: A particle is its own neighbour.
let (xi, yi) = (bodies.x[i], bodies.y[i]);
for j in range {
    let (dx, dy) = (bodies.x[j] - xi, bodies.y[j] - yi);
    if dx * dx + dy * dy <= reach * reach {
        list.push(j as u32);
    }
}
