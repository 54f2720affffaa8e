//! Soft discs on a device: the sort, and steps.

use common::soft::{CUTOFF, Particle, Scene};
use device_discs::soft::{Double, Options, SoftDiscs};
use lab9::{Lab9, VARIANTS};

use super::{ask, gpu, questions};
use crate::{Answers, Random};

#[path = "soft.rs"]
mod soft;

use soft::Engine;

/// Few enough bins for one block of the scan: longer ones are another task.
fn scene(random: &mut Random) -> Scene {
    let n = 120 + random.below(60);
    soft::spread(random, n, 10.3 * CUTOFF, 1.0)
}

/// The order of particles, and steps in double precision where the device has it.
pub fn sorts(random: &mut Random, answers: &mut Answers) {
    let gpu = gpu();
    gpu.expect_real::<f64>().unwrap_or_else(|error| {
        panic!("{error}; WGPU_ADAPTER_NAME=llvmpipe names one made of software, which has it")
    });
    let options = Options { threads: 256, bin: 1.0, in_flight: 1, statistics: false };
    let engine = SoftDiscs::<Lab9, Double>::new(gpu, options, None);
    let mut engine = engine.unwrap_or_else(|error| panic!("{error}"));
    for round in 0..3 {
        let name = format!("scene {round}");
        questions::bins(&mut engine, (&name, &scene(random)), &mut answers.told());
    }
    let mut engine = Engine::new(VARIANTS, "soft-f64", 1, &[("workgroup", 256.0)]);
    let mut ask = |name: &str, scene: &Scene, steps| {
        answers.steps(&format!("soft-f64, {name}"), &engine.run(scene, steps));
    };
    ask("10.3 cutoffs", &scene(random), 6 + random.below(9));
    let many = 150 + random.below(100);
    ask("a crowd", &soft::crowd(random, many, 2.55 * CUTOFF, 1.0), 1);
    let mut pairs = Engine::new(VARIANTS, "soft-f64", 1, &[("workgroup", 256.0), ("bin", 3.0)]);
    let scene = soft::pairs_over_edges(random);
    answers.steps("soft-f64, pairs over edges", &pairs.run(&scene, 1));
}

/// 400 pairs at a tenth of a cutoff, in a box 200 cutoffs wide.
fn close_pairs(random: &mut Random) -> Scene {
    let mut particles = Vec::new();
    for pair in 0..400 {
        let mut along = |at: usize| ((10 * at + 5) as f64 + random.between(-3.0, 3.0)) * CUTOFF;
        let (x, y) = (along(pair % 20), along(pair / 20));
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let (dx, dy) = (0.05 * CUTOFF * cos, 0.05 * CUTOFF * sin);
        let at = |x, y| Particle { x, y, ..Particle::default() };
        particles.extend([at(x - dx, y - dy), at(x + dx, y + dy)]);
    }
    Scene::new(200.0 * CUTOFF, particles).expect("all are in the box")
}

/// Single precision has seven digits of a bin and of a velocity; answers are compared to ten, so
/// positions are told in ten thousandths and velocities in ten millionths.
pub fn single(random: &mut Random, answers: &mut Answers) {
    let parameters = [("workgroup", 256.0), ("bin", 3.0)];
    let mut engine = Engine::new(VARIANTS, "soft-f32", 1, &parameters);
    let many = 250 + random.below(100);
    for (name, scene) in [
        ("pairs over edges", soft::pairs_over_edges(random)),
        ("10.3 cutoffs", scene(random)),
        ("15.3 cutoffs", soft::spread(random, many, 15.3 * CUTOFF, 0.5)),
    ] {
        let run = engine.run(&scene, 1);
        for (id, p) in run[2 + 4 * scene.len()..].chunks_exact(4).enumerate() {
            let question = format!("soft-f32, {name}: x y vx vy of particle {id} after a step");
            answers.close(&question, &[p[0] / 1e4, p[1] / 1e4, p[2] / 1e7, p[3] / 1e7]);
        }
    }
    // A position that counts from the corner of a wide box is off by a hundred times as much as one that
    // counts from a bin's, and so is a force: by a tenth of a unit of velocity and not a thousandth.
    let scene = close_pairs(random);
    let run = engine.run(&scene, 1);
    for (id, p) in run[2 + 4 * scene.len()..].chunks_exact(4).enumerate() {
        let question = format!("soft-f32, close pairs in a wide box: vx vy of particle {id}");
        answers.close(&question, &[p[2] / 1e8, p[3] / 1e8]);
    }
}
