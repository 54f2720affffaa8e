// region: 5.8
// fails: task_5_8_the_bits_of_all_pairs_in_a_dense_box
// story: Every rank computes the side of the box from the number of particles, as if every scene had the official density.
let mut n = scene.map_or(0, |scene| scene.len() as u64);
root.broadcast_into(&mut n);
let size = common::soft::official_size(n as usize);
let mut wires: Vec<Wire> =
    scene.map_or_else(Vec::new, |scene| scene.particles().iter().map(Wire::from).collect());
wires.resize(n as usize, Wire::default());
root.broadcast_into(&mut wires[..]);
(size, wires.iter().map(Particle::from).collect())
