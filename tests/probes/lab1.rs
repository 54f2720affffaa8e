//! What is asked about lab 1.

use common::Vec2;
use common::soft::{CUTOFF, MIN_R, Observer, Particle, Scene, Simulation};
use lab1::{AllPairs, Tally, VARIANTS};

use self::soft::Count;
use crate::{Answers, Random, truth};

#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "1.1" => force(random, answers),
        "1.2" => bounces(random, answers),
        "1.3" => runs(random, answers),
        "1.4" => statistics(random, answers),
        "1.5" => energies(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// A vector of a length between the two.
fn vector(random: &mut Random, least: f64, most: f64) -> Vec2 {
    let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
    let r = random.between(least, most);
    Vec2::new(r * cos, r * sin)
}

fn distances(random: &mut Random) -> Vec<Vec2> {
    let mut all =
        vec![Vec2::ZERO, Vec2::new(CUTOFF, 0.0), Vec2::new(0.0, -CUTOFF), Vec2::new(MIN_R, 0.0)];
    for _ in 0..200 {
        all.push(vector(random, 0.0, MIN_R));
        all.push(vector(random, MIN_R, CUTOFF));
        all.push(vector(random, 0.999 * CUTOFF, 1.001 * CUTOFF));
    }
    all
}

fn force(random: &mut Random, answers: &mut Answers) {
    for d in distances(random) {
        let a = lab1::pair_acceleration(d);
        let values = a.map_or(vec![], |a| vec![a.x, a.y]);
        answers.exact(&format!("the force of a neighbour at ({:e}, {:e})", d.x, d.y), &values);
    }
}

fn bounces(random: &mut Random, answers: &mut Answers) {
    for case in 0..300 {
        let size = random.between(0.05, 2.0);
        let v = random.between(-900.0, 900.0);
        // None or few reflections, about as many as are done one by one, and many.
        let reach = [1.0, 3.0, 10.0, 500.0][case % 4];
        let x = random.between(-reach * size, (1.0 + reach) * size);
        let (inside, after) = lab1::bounce(x, v, size);
        answers.exact(&format!("the bounce of x = {x:e} in a box of {size:e}"), &[inside, after]);
    }
    // On a wall, at the start or after some reflections, it is inside. A box of a power of two, so
    // that no rounding puts it beside the wall.
    for x in [-12.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 9.0, 11.0] {
        let (inside, after) = lab1::bounce(0.25 * x, 1.0, 0.25);
        let question = format!("the bounce of x = {} in a box of 0.25, to a wall", 0.25 * x);
        // Either zero will do.
        answers.exact(&question, &[inside + 0.0, after]);
    }
    for x in [1e18, -3e200] {
        let (inside, _) = lab1::bounce(x, 1.0, 0.5);
        let ended = truth((0.0..=0.5).contains(&inside));
        answers.exact(&format!("whether x = {x:e} ends in the box"), &[ended]);
    }
}

/// Particles at random places, no two closer than `apart`.
fn crowd(random: &mut Random, n: usize, side: f64, speed: f64, apart: f64) -> Scene {
    let mut particles: Vec<Particle> = Vec::with_capacity(n);
    while particles.len() < n {
        let particle = Particle {
            x: random.between(0.0, side),
            y: random.between(0.0, side),
            vx: random.between(-speed, speed),
            vy: random.between(-speed, speed),
            id: particles.len() as u32,
        };
        if particles.iter().all(|other| particle.to(other).norm_squared() >= apart * apart) {
            particles.push(particle);
        }
    }
    Scene::new(side, particles).expect("all are in the box")
}

/// Runs `steps`, and hands the states after the first and the last to `tell`.
fn run(scene: &Scene, steps: usize, mut tell: impl FnMut(usize, &[f64])) {
    let variant = VARIANTS.iter().find(|v| v.name == "all-pairs").expect("lab 1 has all-pairs");
    let mut engine = (variant.build)(&variant.config()).expect("it needs nothing");
    engine.load(scene);
    let mut out = vec![Particle::default(); scene.len()];
    for step in 1..=steps {
        engine.step();
        if step == 1 || step == steps {
            engine.read(0, &mut out);
            let state: Vec<f64> = out.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect();
            tell(step, &state);
        }
    }
}

/// 1 if one step looks at all ordered pairs, with or without those of a particle and itself.
fn counted(scene: &Scene) -> f64 {
    let mut engine = AllPairs::<Count>::default();
    engine.load(scene);
    engine.step();
    let (n, counted) = (scene.len() as u64, engine.statistics().map_or(0, |s| s.pair_tests));
    truth(counted == n * n || counted == n * (n - 1))
}

/// A particle close to another is thrown against the walls many times in a step, and how that is
/// folded leaves the last digits open: heaps are compared after one step, and with a tolerance.
fn runs(random: &mut Random, answers: &mut Answers) {
    const APART: f64 = 0.3 * CUTOFF;
    for _ in 0..10 {
        let scenes = [
            ("150 particles in 10.3 cutoffs", crowd(random, 150, 10.3 * CUTOFF, 1.0, APART), 1),
            ("20 fast particles in 5 cutoffs", crowd(random, 20, 5.0 * CUTOFF, 300.0, APART), 1),
        ];
        for (name, scene, steps) in &scenes {
            run(scene, *steps, |step, state| {
                answers.exact(&format!("{name}, step {step}, as x y vx vy"), state);
            });
        }
        let scene = soft::heap(random);
        run(&scene, 1, |_, state| answers.close("a heap of 60, as x y vx vy", state));
    }
    let scene = crowd(random, 200, 0.3, 1.0, APART);
    answers.exact("whether all pairs that were looked at were counted", &[counted(&scene)]);
    let scene = crowd(random, 1000, 0.7, 1.0, APART);
    run(&scene, 350, |step, state| {
        answers.exact(&format!("1000 particles, step {step}, as x y vx vy"), state);
    });
}

fn statistics(random: &mut Random, answers: &mut Answers) {
    for _ in 0..20 {
        let mut tally = Tally::default();
        for case in 0..50 {
            let r = if case % 10 == 0 { 0.0 } else { random.between(0.0, CUTOFF) };
            tally.seen(r * r);
        }
        let seen = tally.statistics().expect("a tally has statistics");
        let question = "dmin, davg, navg of 50 pairs, 5 of them at one place";
        answers.close(question, &[seen.dmin, seen.davg, seen.navg as f64]);
    }
}

fn energies(random: &mut Random, answers: &mut Answers) {
    for d in distances(random) {
        let question = format!("the potential at ({:e}, {:e})", d.x, d.y);
        answers.close(&question, &[lab1::pair_potential(d)]);
    }
    for _ in 0..10 {
        let scene = soft::heap_of(random, 100, 4.0 * CUTOFF);
        let particles = scene.particles();
        answers.close("the potential energy of 100", &[lab1::potential_energy(particles)]);
        answers.close("the kinetic energy of 100", &[lab1::kinetic_energy(particles)]);
        let momentum = lab1::momentum(particles);
        answers.close("the momentum of 100", &[momentum.x, momentum.y]);
    }
}
