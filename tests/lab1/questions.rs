//! What tests and probe ask alike, with drawn inputs and what the model says.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Observer, Particle, Scene, Simulation};
use lab1::{
    AllPairs, Tally, bounce, kinetic_energy, momentum, pair_acceleration, pair_potential,
    potential_energy,
};

use super::ask::{Ask, beside, rounded};
use super::{Count, Model, acceleration_of_pair, anywhere, fold, potential_of_pair};
use crate::Random;

/// Vectors along the axes and in any direction, of any length, and of those at which a formula changes.
fn distances(random: &mut Random) -> Vec<Vec2> {
    let mut all = vec![Vec2::ZERO];
    for length in [MIN_R, CUTOFF].into_iter().flat_map(beside) {
        let axes = [(length, 0.0), (-length, 0.0), (0.0, length), (0.0, -length)];
        all.extend(axes.map(|(x, y)| Vec2::new(x, y)));
    }
    for case in 0..2000 {
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let length = match case % 4 {
            0 => MIN_R,
            1 => CUTOFF,
            2 => CUTOFF * random.around_one(),
            _ => CUTOFF * random.magnitude(1e-12, 10.0),
        };
        all.push(length * Vec2::new(cos, sin));
    }
    all
}

/// Where a neighbour is.
fn neighbour(d: Vec2) -> String {
    let cutoffs = d.norm_squared().sqrt() / CUTOFF;
    format!("a neighbour at ({:?}, {:?}), {cutoffs:?} cutoffs away", d.x, d.y)
}

/// The force of any neighbour, near or far.
pub(super) fn forces(random: &mut Random, ask: Ask<'_>) {
    for d in distances(random) {
        let found = pair_acceleration(d).map_or(vec![], |a| vec![a.x, a.y]);
        let is_near = d.norm_squared() <= CUTOFF * CUTOFF;
        let a = acceleration_of_pair(d.x, d.y);
        let right = if is_near { vec![a.x, a.y] } else { vec![] };
        ask(&format!("{}: its force, [] for none", neighbour(d)), found, right);
    }
}

/// Any coordinate in any box: inside, on a wall or beside it, also after some reflections, and very far outside.
pub(super) fn bounces(random: &mut Random, ask: Ask<'_>) {
    for case in 0..4000 {
        let of_two = 2_f64.powi(random.below(60) as i32 - 30);
        let size = [of_two, random.magnitude(1e-9, 1e9)][case % 2];
        let reach = [1.0, 3.0, 10.0, 500.0, 1e18][case / 2 % 5];
        let x = match case / 10 % 4 {
            0 => beside(size * (random.below(27) as f64 - 13.0))[random.below(3)],
            1 => [0.0, -0.0, -f64::MIN_POSITIVE][random.below(3)],
            2 if case % 100 == 20 => [f64::MAX, -f64::MAX][random.below(2)],
            _ => random.between(-reach * size, (1.0 + reach) * size),
        };
        let v = random.signed(1e-6, 1e6);
        let [found, right] = [bounce(x, v, size), fold(x, v, size)];
        // Either zero will do.
        let [found, right] = [found, right].map(|(x, v)| vec![x + 0.0, v]);
        let (walls, sizes) = ((x / size).fract() == 0.0, x / size);
        let ends = if walls { "; it ends on a wall, which is inside" } else { "" };
        let question = format!("x = {x:e}, {sizes:.15} times the box of {size:e}, v = {v:e}{ends}");
        ask(&question, found, right);
    }
}

/// A step of any number of particles, few or many in reach of each, and then of a few; and what was looked at.
pub(super) fn steps(random: &mut Random, ask: Ask<'_>) {
    let mut engine = AllPairs::<Count>::default();
    let sizes = [random.sizes(4097), vec![3, 1]].concat();
    for n in sizes.into_iter().filter(|&n| n > 0) {
        let crowd = random.magnitude(0.3, 10.0);
        let size = CUTOFF * (n as f64 / crowd).sqrt().max(random.magnitude(0.5, 2.0));
        let scene = anywhere(random, n, size, 1.0);
        let mut model = Model::new(&scene);
        model.step();
        engine.load(&scene);
        engine.step();
        let mut found = vec![Particle::default(); n];
        engine.read(0, &mut found);
        let numbers = |all: &[Particle]| {
            all.iter().flat_map(|p| [p.x + 0.0, p.y + 0.0, p.vx, p.vy]).collect::<Vec<f64>>()
        };
        let name = format!("a step of {n} particles in a box of {:.2} cutoffs", size / CUTOFF);
        let question = format!("{name}: x y vx vy of each");
        ask(&question, numbers(&found), numbers(&model.particles));
        let told = engine.statistics().map_or(0, |s| s.pair_tests) as f64;
        let all = (n * n) as f64;
        // A particle may look at itself or not.
        let told = if told == all - n as f64 { all } else { told };
        ask(&format!("{name}: how many pairs the observer was told of"), vec![told], vec![all]);
    }
    let at = |x: f64, y: f64| Particle { x: x * CUTOFF, y: y * CUTOFF, ..Particle::default() };
    let particles = vec![at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
    engine.load(&Scene::new(2.0 * CUTOFF, particles).expect("all are in the box"));
    engine.step();
    let told = engine.statistics().map_or(0, |s| s.navg) as f64;
    let question = "two particles exactly a cutoff from a third, along x and along y: how many pairs within the \
                    cutoff the observer was told of, each from both sides";
    ask(question, vec![told], vec![4.0]);
}

/// Any number of pairs, at the cutoff or very near, and others at one position.
pub(super) fn tallies(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(70_000) {
        let (mut tally, mut counted, mut at_one_position) = (Tally::default(), Vec::new(), 0);
        for _ in 0..n {
            let r = [1.0, random.magnitude(1e-20, 1.0)][usize::from(random.below(8) > 0)];
            tally.seen((r * CUTOFF) * (r * CUTOFF));
            counted.push(r);
            if random.below(8) == 0 {
                tally.seen(0.0);
                at_one_position += 1;
            }
        }
        let found = tally.statistics().expect("a tally has statistics");
        let least = counted.iter().copied().fold(1.0, f64::min);
        let sum: f64 = counted.iter().sum();
        let name = format!("{n} pairs, and {at_one_position} at one position");
        ask(&format!("{name}: navg, how many count"), vec![found.navg as f64], vec![n as f64]);
        let question = format!("{name}: dmin, the least distance above zero in cutoffs");
        ask(&question, vec![rounded(found.dmin, least, least)], vec![least]);
        let question = format!("{name}: davg, the sum of distances in cutoffs");
        ask(&question, vec![rounded(found.davg, sum, sum)], vec![sum]);
    }
}

/// The potential of any pair.
pub(super) fn potentials(random: &mut Random, ask: Ask<'_>) {
    for d in distances(random) {
        let right = potential_of_pair(d.x, d.y);
        let found = rounded(pair_potential(d), right, 1.0 + right);
        ask(&format!("{}: the potential", neighbour(d)), vec![found], vec![right]);
    }
}

/// The energies and the momentum of any number of particles, slow and fast, some at one position.
pub(super) fn energies(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(65_537) {
        let size = CUTOFF * random.magnitude(0.5, 20.0);
        let fastest = random.magnitude(1e-6, 1e6);
        let mut particles: Vec<Particle> = Vec::with_capacity(n);
        for id in 0..n as u32 {
            let mut speed = || match random.below(5) {
                0 => 0.0,
                _ => random.signed(1e-3 * fastest, fastest),
            };
            let (vx, vy) = (speed(), speed());
            let (x, y) = match particles.last() {
                Some(before) if random.below(9) == 0 => (before.x, before.y),
                _ => (random.between(0.0, size), random.between(0.0, size)),
            };
            particles.push(Particle { x, y, vx, vy, id });
        }
        let name = format!("{n} particles with velocities up to {fastest:.1e}");
        let right: f64 = particles.iter().map(|p| 0.5 * MASS * (p.vx * p.vx + p.vy * p.vy)).sum();
        let found = rounded(kinetic_energy(&particles), right, right);
        ask(&format!("{name}: the energy of motion, of m v² / 2"), vec![found], vec![right]);
        let found = momentum(&particles);
        for (axis, found, of) in
            [("x", found.x, (|p| p.vx) as fn(&Particle) -> f64), ("y", found.y, |p| p.vy)]
        {
            let sum =
                |of: &dyn Fn(&Particle) -> f64| particles.iter().map(|p| MASS * of(p)).sum::<f64>();
            let (right, scale) = (sum(&of), sum(&|p| of(p).abs()));
            let found = vec![rounded(found, right, scale)];
            ask(&format!("{name}: the momentum along {axis}, of m v"), found, vec![right]);
        }
        if n <= 1025 {
            let found = potential_energy(&particles);
            let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
            let right: f64 = pairs
                .map(|(i, j)| particles[i].to(&particles[j]))
                .map(|d| potential_of_pair(d.x, d.y))
                .sum();
            let found = vec![rounded(found, right, n as f64 + right)];
            let question = format!(
                "{n} particles in a box of {:.1} cutoffs: the potential energy, of each pair once",
                size / CUTOFF
            );
            ask(&question, found, vec![right]);
        }
    }
}
