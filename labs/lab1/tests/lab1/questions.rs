//! Questions with random inputs, and the model's answers.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Observer, Particle, Scene, Simulation};
use lab1::{
    AllPairs, Tally, VARIANTS, bounce, kinetic_energy, momentum, pair_acceleration, pair_potential,
    potential_energy,
};
use oracle::scenes::{self, anywhere};
use oracle::{
    Ask, Count, Model, Near, Random, Runs, acceleration_of_pair, beside, fold, potential_of_pair,
};

/// Draws vectors along the axes and in any direction, of any length, including the lengths at which
/// a formula changes.
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

/// Describes the position of a neighbour.
fn neighbour(d: Vec2) -> String {
    let cutoffs = d.norm_squared().sqrt() / CUTOFF;
    format!("a neighbour at ({:?}, {:?}), {cutoffs:?} cutoffs away", d.x, d.y)
}

/// Asks whether the forces on a particle and on its neighbour are opposite.
pub(crate) fn opposite(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..10_000 {
        let mut along = || CUTOFF * random.between(-0.8, 0.8);
        let d = Vec2::new(along(), along());
        let question = format!(
            "{}: ax ay of the particle's acceleration, then ax ay of the neighbour's acceleration",
            neighbour(d)
        );
        let found = || [d, -d].into_iter().filter_map(pair_acceleration).flat_map(|a| [a.x, a.y]);
        ask.judge(&question, || found().collect(), |found| straight_away(d, found));
    }
}

/// Checks that the forces of a pair point away from each other, along the line between the
/// particles.
fn straight_away(d: Vec2, found: &[f64]) -> Result<(), String> {
    let &[x, y, back_x, back_y] = found else {
        let is_near = d.norm_squared() <= CUTOFF * CUTOFF;
        return if is_near {
            Err("an acceleration is missing, although the particles are within the cutoff".into())
        } else {
            Ok(())
        };
    };
    let (a, back) = (Vec2::new(x, y), Vec2::new(back_x, back_y));
    if a.dot(d) > 0.0 {
        return Err(format!(
            "the particle is accelerated by ({x}, {y}), which points towards its neighbour. The neighbour must repel \
             the particle"
        ));
    }
    if a.cross(d).abs() > 1e-12 * a.dot(d).abs() {
        return Err(format!(
            "the particle is accelerated by ({x}, {y}), which is not along the line between the particle and its \
             neighbour"
        ));
    }
    if back != -a {
        return Err(format!(
            "the particle is accelerated by ({x}, {y}) and its neighbour by ({back_x}, {back_y}): the two \
             accelerations must be opposite"
        ));
    }
    Ok(())
}

/// Asks for the force of any neighbour, near or far.
pub(crate) fn forces(random: &mut Random, ask: &mut impl Ask) {
    for d in distances(random) {
        let found = || pair_acceleration(d).map_or(vec![], |a| vec![a.x, a.y]);
        ask.exact(
            &format!(
                "{}: acceleration of the particle, ax ay, or [] beyond the cutoff",
                neighbour(d)
            ),
            found,
            || {
                let a = acceleration_of_pair(d.x, d.y);
                if d.norm_squared() <= CUTOFF * CUTOFF { vec![a.x, a.y] } else { vec![] }
            },
        );
    }
}

/// Asks about any coordinate in any box: inside, on a wall or beside it, also after several
/// reflections.
pub(crate) fn bounces(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..4000 {
        let size = any_size(random, case);
        let reach = [1.0, 3.0, 10.0, 500.0][case / 2 % 4];
        let x = match case / 8 % 4 {
            0 => beside(size * (random.below(27) as f64 - 13.0))[random.below(3)],
            1 => [0.0, -0.0, -f64::MIN_POSITIVE][random.below(3)],
            _ => random.between(-reach * size, (1.0 + reach) * size),
        };
        bounced(x, size, random, ask);
    }
}

/// Asks about coordinates so large that a reflection does not change them.
pub(crate) fn far_outside(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..200 {
        let size = any_size(random, case);
        let x = match case % 8 {
            0 => [f64::MAX, -f64::MAX][random.below(2)],
            _ => random.signed(1e16, 1e19) * size,
        };
        bounced(x, size, random, ask);
    }
}

/// Draws a power of two, which avoids rounding, or any number.
fn any_size(random: &mut Random, case: usize) -> f64 {
    let of_two = 2_f64.powi(random.below(60) as i32 - 30);
    [of_two, random.magnitude(1e-9, 1e9)][case % 2]
}

fn bounced(x: f64, size: f64, random: &mut Random, ask: &mut impl Ask) {
    let v = random.signed(1e-6, 1e6);
    // Negative zero becomes zero.
    let ends = |(x, v): (f64, f64)| vec![x + 0.0, v];
    let sizes = x / size;
    let on_a_wall = if sizes.fract() == 0.0 {
        " (the particle ends on a wall, which counts as inside)"
    } else {
        ""
    };
    let question = format!(
        "a box from 0 to {size:e}. Without walls, a particle would fly to x = {x:e} ({sizes:.15} times the side of \
         the box) with v = {v:e}{on_a_wall}: x and v after reflections"
    );
    ask.exact(&question, || ends(bounce(x, v, size)), || ends(fold(x, v, size)));
}

/// Asks for a step of any number of particles, with few or many within reach of each, and finally
/// of a few particles.
pub(crate) fn steps(random: &mut Random, ask: &mut impl Ask) {
    let mut engine = AllPairs::<Count>::default();
    for n in [random.sizes(1025), vec![3, 1]].concat() {
        step(&mut engine, n, random, ask);
    }
}

pub(crate) fn many_particles(random: &mut Random, ask: &mut impl Ask) {
    step(&mut AllPairs::default(), 4097, random, ask);
}

fn step(engine: &mut AllPairs<Count>, n: usize, random: &mut Random, ask: &mut impl Ask) {
    let crowd = random.magnitude(0.3, 10.0);
    let size = CUTOFF * (n as f64 / crowd).sqrt().max(random.magnitude(0.5, 2.0));
    // A scene has at least one particle.
    let scene = anywhere(random, n.max(1), size, 1.0);
    engine.load(&scene);
    engine.step();
    let cutoffs = size / CUTOFF;
    let question = format!(
        "a step of {} particles in a box of {cutoffs:.2} cutoffs: x y vx vy of each particle",
        scene.len()
    );
    let found = || {
        let mut found = scene.particles().to_vec();
        engine.read(0, &mut found);
        numbers(&found)
    };
    ask.exact(&question, found, || {
        let mut model = Model::new(&scene);
        model.step();
        numbers(&model.particles)
    });
}

/// Asks for the reports to the observer in a step of any number of particles.
pub(crate) fn looks(random: &mut Random, ask: &mut impl Ask) {
    let mut engine = AllPairs::<Count>::default();
    for n in [random.sizes(1025), vec![3, 1]].concat().into_iter().filter(|&n| n > 0) {
        engine.load(&anywhere(random, n, 10.0 * CUTOFF, 1.0));
        engine.step();
        let tests = engine.statistics().map_or(0, |s| s.pair_tests) as f64;
        let question = format!(
            "a step of {n} particles: number of pair tests reported to the observer (`tested`)"
        );
        ask.judge(&question, || vec![tests], |found| every_pair(n as f64, found));
    }
}

/// Returns x, y, vx, vy of each particle. Negative zero as a position becomes zero.
fn numbers(particles: &[Particle]) -> Vec<f64> {
    particles.iter().flat_map(|p| [p.x + 0.0, p.y + 0.0, p.vx, p.vy]).collect()
}

/// Checks that the number of pairs is right for n particles. A particle may be paired with itself
/// or not.
fn every_pair(n: f64, found: &[f64]) -> Result<(), String> {
    if [vec![n * n], vec![n * n - n]].iter().any(|right| right == found) {
        return Ok(());
    }
    Err(format!("     found: {found:?}\n  expected: [{}]", n * n))
}

pub(crate) fn at_the_cutoff(_: &mut Random, ask: &mut impl Ask) {
    let mut engine = AllPairs::<Count>::default();
    engine.load(&scenes::at_the_cutoff());
    engine.step();
    let seen = engine.statistics().map_or(0, |s| s.navg) as f64;
    let question = "two particles that are each exactly one cutoff from a third particle, one along x and one along \
                    y: number of pairs within the cutoff that are reported to the observer (`seen`). Each pair is \
                    reported twice, once for each of its particles";
    ask.exact(question, || vec![seen], || vec![4.0]);
}

/// Asks about any number of pairs, at the cutoff or very near, and others at one position.
pub(crate) fn tallies(random: &mut Random, ask: &mut impl Ask) {
    // The empty list comes last, because an unsolved starter answers it correctly.
    for n in random.sizes(70_000).into_iter().skip(1).chain([0]) {
        let (mut tally, mut distances, mut at_one_position) = (Tally::default(), Vec::new(), 0);
        for _ in 0..n {
            let r = [1.0, random.magnitude(1e-20, 1.0)][usize::from(random.below(8) > 0)];
            tally.seen((r * CUTOFF) * (r * CUTOFF));
            distances.push(r);
            if random.below(8) == 0 {
                tally.seen(0.0);
                at_one_position += 1;
            }
        }
        let seen = tally.statistics().expect("a tally returns statistics");
        let name = format!(
            "{n} pairs at different positions, and {at_one_position} pairs whose two particles are at one position"
        );
        let question =
            format!("{name}: navg, the number of pairs, without the pairs at one position");
        ask.exact(&question, || vec![seen.navg as f64], || vec![n as f64]);
        let question = format!("{name}: dmin, the least distance above zero, in cutoffs");
        let near = |right: f64| vec![Near { right, scale: right }];
        let least = || near(distances.iter().copied().fold(1.0, f64::min));
        ask.near(&question, || vec![seen.dmin], least);
        let question = format!("{name}: davg, the sum of the distances, in cutoffs");
        ask.near(&question, || vec![seen.davg], || near(distances.iter().sum()));
    }
}

/// Asks for the potential of any pair.
pub(crate) fn potentials(random: &mut Random, ask: &mut impl Ask) {
    for d in distances(random) {
        let question = format!("{}: potential of the pair", neighbour(d));
        ask.near(
            &question,
            || vec![pair_potential(d)],
            || {
                let right = potential_of_pair(d.x, d.y);
                vec![Near { right, scale: 1.0 + right }]
            },
        );
    }
}

/// Asks for the energies and the momentum of any number of particles, slow and fast, some at one
/// position.
pub(crate) fn energies(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(65_537) {
        let size = CUTOFF * random.magnitude(0.5, 20.0);
        let fastest = random.magnitude(1e-6, 1e6);
        let particles = moving(random, n, size, fastest);
        let name = format!("{n} particles with velocities up to {fastest:.1e}");
        let question = format!("{name}: kinetic energy, the sum of m v² / 2");
        ask.near(
            &question,
            || vec![kinetic_energy(&particles)],
            || {
                let right =
                    particles.iter().map(|p| 0.5 * MASS * (p.vx * p.vx + p.vy * p.vy)).sum();
                vec![Near { right, scale: right }]
            },
        );
        let found = || {
            let all = momentum(&particles);
            vec![all.x, all.y]
        };
        let question = format!("{name}: momentum, the sums of m vx and of m vy");
        ask.near(&question, found, || {
            [|p: &Particle| MASS * p.vx, |p: &Particle| MASS * p.vy]
                .map(|of| summed(&particles, of))
                .to_vec()
        });
        if n <= 1025 {
            let name = format!("{n} particles in a box of {:.1} cutoffs", size / CUTOFF);
            let question = format!("{name}: potential energy, to which each pair contributes once");
            ask.near(
                &question,
                || vec![potential_energy(&particles)],
                || {
                    let right = potential_of_all(&particles);
                    vec![Near { right, scale: n as f64 + right }]
                },
            );
        }
    }
}

/// Draws particles in a box of side `size`, slow and fast. Some have the position of the previous
/// particle.
fn moving(random: &mut Random, n: usize, size: f64, fastest: f64) -> Vec<Particle> {
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
    particles
}

fn summed(particles: &[Particle], of: fn(&Particle) -> f64) -> Near {
    Near {
        right: particles.iter().map(of).sum(),
        scale: particles.iter().map(of).map(f64::abs).sum(),
    }
}

fn potential_of_all(particles: &[Particle]) -> f64 {
    let pairs = (0..particles.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let vectors = pairs.map(|(i, j)| particles[i].to(&particles[j]));
    vectors.map(|d| potential_of_pair(d.x, d.y)).sum()
}

/// Asks about two particles that collide and separate.
pub(crate) fn a_collision(_: &mut Random, ask: &mut impl Ask) {
    let highest = pair_potential(Vec2::new(MIN_R, 0.0));
    let question = "two particles at the least distance, `MIN_R`: potential of the pair, which must be above 90";
    ask.judge(
        question,
        || vec![highest],
        |found| match found {
            [highest] if *highest > 90.0 => Ok(()),
            _ => Err(format!("the potential is {found:?}, which is too low")),
        },
    );
    let at = |x: f64, vx: f64| Particle { x, y: 0.5, vx, ..Particle::default() };
    let scene = Scene::new(1.0, vec![at(0.45, 0.5), at(0.55, -0.5)]).expect("the scene is valid");
    let found = move |engine: &mut dyn Simulation| {
        let mut state = scene.particles().to_vec();
        let start = kinetic_energy(&state) + potential_energy(&state);
        engine.load(&scene);
        (0..400).for_each(|_| engine.step());
        engine.read(0, &mut state);
        let end = kinetic_energy(&state) + potential_energy(&state);
        vec![end / start - 1.0, momentum(&state).x]
    };
    let question = "two particles that collide and fly apart again, after 400 steps: (1) relative change of the \
                    energy, (2) momentum along x";
    ask.judge(
        question,
        || Runs::new("1.5", VARIANTS, "energy").run(found),
        |found| match found {
            [change, momentum] if change.abs() < 0.05 && momentum.abs() < 1e-14 => Ok(()),
            _ => Err(format!(
                "     found: {found:?}\n  expected: (1) a change of less than 0.05, (2) 0"
            )),
        },
    );
}
