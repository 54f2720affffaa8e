// region: 5.8
// fails: task_5_8_all_ranks_get_the_scene
// story: The root sends the scene to one rank after the other: right, and no collective operation.
if world.rank() != ROOT {
    let size: f64 = root.receive().0;
    let wires: Vec<Wire> = root.receive_vec().0;
    return (size, wires.iter().map(Particle::from).collect());
}
let scene = scene.expect("it is there on the root");
let wires: Vec<Wire> = scene.particles().iter().map(Wire::from).collect();
for rank in 1..world.size() {
    let other = world.process_at_rank(rank);
    other.send(&scene.size());
    other.send(&wires[..]);
}
(scene.size(), scene.particles().to_vec())
