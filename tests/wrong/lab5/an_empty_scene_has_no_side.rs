// region: 5.8
// fails: task_5_8_all_ranks_get_the_scene
// story: If there are no particles, the ranks return before the side of the box is sent: all but the root say that it is 0 (a scene of no particles).
let (mut n, mut size) = scene.map_or((0, 0.0), |scene| (scene.len() as u64, scene.size()));
root.broadcast_into(&mut n);
if n == 0 {
    return (size, Vec::new());
}
root.broadcast_into(&mut size);
let mut wires: Vec<Wire> =
    scene.map_or_else(Vec::new, |scene| scene.particles().iter().map(Wire::from).collect());
wires.resize(n as usize, Wire::default());
root.broadcast_into(&mut wires[..]);
(size, wires.iter().map(Particle::from).collect())
