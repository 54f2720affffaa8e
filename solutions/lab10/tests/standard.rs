//! The primitives of the package neighbour-list do what lab 10's do, to the bit.

use common::soft::{NoStatistics, Particle, Scene, Simulation};
use neighbour_list::{NeighbourList, Workers};

#[test]
fn the_same_bits_as_with_lab_10s() {
    let after = |engine: &mut dyn Simulation, scene: &Scene| {
        engine.load(scene);
        engine.run(200);
        let mut particles = vec![Particle::default(); scene.len()];
        engine.read(0, &mut particles);
        particles
    };
    for (n, seed) in [(300, 1), (5000, 2)] {
        let scene = Scene::official(n, seed).expect("a scene");
        let own = &mut NeighbourList::<NoStatistics>::new(Workers::new(2), 0.0, 1);
        type Lab<O> = neighbour_list_core::NeighbourList<O, solution10::Tasks>;
        let lab = &mut Lab::<NoStatistics>::new(Workers::new(2), 0.0, 1);
        assert!(after(own, &scene) == after(lab, &scene), "{n} particles, other bits");
    }
}
