//! Single precision relative to a cell is equally accurate everywhere in a box of any size.

use common::soft::{CUTOFF, Particle, Scene, Simulation};
use integrators::Mixed;
use oracle::{Model, Random};

/// Returns the greatest error of 64 particles after three steps.
///
/// The particles begin near a corner, at a distance `offset` from the walls of a box of side
/// `size`.
fn error(size: f64, offset: f64) -> f64 {
    let mut random = Random::new(4);
    let particles = (0..64_u32).map(|id| {
        let [x, y] = [id % 8, id / 8].map(|k| (1.0 + 0.9 * f64::from(k)) * CUTOFF + offset);
        let vx = random.between(-1.0, 1.0);
        Particle { x, y, vx, vy: random.between(-1.0, 1.0), id }
    });
    let scene = Scene::new(size, particles.collect()).expect("a scene");
    let mut mixed = Mixed::new(1, 1);
    let mut model = Model::new(&scene);
    mixed.load(&scene);
    for _ in 0..3 {
        mixed.step();
        model.step();
    }
    let mut found = vec![Particle::default(); scene.len()];
    mixed.read(0, &mut found);
    let off = found.iter().zip(&model.particles).map(|(a, b)| a.to(b).norm_squared().sqrt());
    off.fold(0.0, f64::max)
}

#[test]
fn the_error_does_not_depend_on_the_box() {
    for (size, offset) in [(0.1, 0.0), (10.0, 9.0), (1e4, 9e3)] {
        let off = error(size, offset);
        assert!(off < 1e-4 * CUTOFF, "in a box of {size}, {offset} from its walls: off by {off:e}");
    }
}
