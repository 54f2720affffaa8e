// region: 5.8
// fails: task_5_8_all_ranks_get_the_scene
// story: The number of particles in sixteen bits: of 70,000 the ranks hear of 4,464.
let (mut n, mut size) = scene.map_or((0, 0.0), |scene| (scene.len() as u16, scene.size()));
root.broadcast_into(&mut n);
root.broadcast_into(&mut size);
let mut wires: Vec<Wire> =
    scene.map_or_else(Vec::new, |scene| scene.particles().iter().map(Wire::from).collect());
wires.resize(n.into(), Wire::default());
root.broadcast_into(&mut wires[..]);
(size, wires.iter().map(Particle::from).collect())
