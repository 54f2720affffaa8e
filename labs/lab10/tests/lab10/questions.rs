//! What tests and probe ask alike, with drawn inputs and what a plain model says: `ask` gets a question, what the
//! lab answers and what is right.

use common::Vec2;
use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation};
use lab10::{Engine, best_skin, collect, drift, expired, filter};
use neighbour_list_core::kernels::{Pair, ROOM};
use neighbour_list_core::list::lasting;
use neighbour_list_core::{
    AnyProcessor, Bodies, EIGHT, Extent, LISTED, Positions, REBUILD, TESTED,
};

use super::ask::{Ask, rounded, truth};
use crate::Random;

/// Any number of particles, any step and box; sometimes one or all of them leave.
pub(super) fn moves(random: &mut Random, ask: Ask<'_>) {
    for n in [random.sizes(4097), random.sizes(100)].concat() {
        let (dt, size) = (random.magnitude(1e-6, 1e3), random.magnitude(1e-9, 1e9));
        let speed = [0.1, 3.0][random.below(2)] * size / dt / (n as f64 + 1.0);
        let mut draw = |low: f64, high: f64, len: usize| -> Vec<f64> {
            (0..len).map(|_| random.between(low, high)).collect()
        };
        let mut x = draw(0.0, size, n);
        let (mut v, a) = (draw(-speed, speed, n + 3), draw(-speed / dt, speed / dt, n + 3));
        let (mut right_x, mut right_v) = (x.clone(), v.clone());
        for i in 0..n {
            right_v[i] += a[i] * dt;
            right_x[i] += right_v[i] * dt;
        }
        let outside = right_x.iter().filter(|x| **x < 0.0 || **x > size).count();
        let from = match n {
            1 | 2 => format!("x = {x:?}, v = {:?}, a = {:?}, dt = {dt:?}: ", &v[..n], &a[..n]),
            _ => String::new(),
        };
        let left = drift(&mut x, &mut v, &a, dt, size);
        let name = format!(
            "{from}{} in a box of side {size:?}, {outside} outside after the step",
            particles(n)
        );
        ask(&format!("{name}: velocities, and three numbers behind"), v, right_v);
        ask(&format!("{name}: positions"), x, right_x);
        ask(
            &format!("{name}: is any outside? 1 for yes, 0 for no"),
            vec![truth(left)],
            vec![truth(outside > 0)],
        );
    }
}

/// A particle on a wall, or as little as possible beside it, among others well inside.
pub(super) fn walls(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(64).into_iter().filter(|&n| n > 0) {
        let (size, i) = (random.magnitude(1e-3, 1e3), random.below(n));
        for at in [0.0, -0.0, -f64::MIN_POSITIVE, size, size.next_up(), size.next_down()] {
            let mut x = vec![0.5 * size; n];
            x[i] = at;
            let left = drift(&mut x, &mut vec![0.0; n], &vec![0.0; n], DT, size);
            let outside = at < 0.0 || at > size;
            let question = format!(
                "index {i} of {}: at {at:?} in a box of side {size:?}, outside? 1 for yes, 0 for no; on a wall is inside",
                particles(n)
            );
            ask(&question, vec![truth(left)], vec![truth(outside)]);
        }
    }
}

/// Any range of particles around one, and any distance.
pub(super) fn lists(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(1025) {
        let unit = random.magnitude(1e-6, 1e6);
        let bodies = drawn(random, n + 1, unit);
        let reach = unit * random.between(0.2, 1.5);
        for _ in 0..8 {
            let (a, b) = (random.below(n + 1), random.below(n + 1));
            let range = a.min(b)..a.max(b);
            let outside = (0..=n).filter(|i| !range.contains(i)).collect::<Vec<_>>();
            let i = outside[random.below(outside.len())];
            let right = range.clone().filter(|&j| squared(&bodies, i, j) <= reach * reach);
            let right = right.flat_map(|j| [i as f64, j as f64]).collect();
            let mut list = vec![[77; 2]; 1 + range.len() + EIGHT];
            let len =
                collect(&mut list, 1, bodies.positions(), i, range.clone(), reach, AnyProcessor);
            let question = format!(
                "{}: those of {range:?} within {reach:.4e} of particle {i}, pairs in a row (77 was there before)",
                particles(n + 1)
            );
            ask(&question, flat(&list, 1..len), right);
        }
    }
}

/// Particles exactly at the reach, and as little as possible beside it.
pub(super) fn reaches(random: &mut Random, ask: Ask<'_>) {
    for unit in [1.0, random.magnitude(1e-9, 1e9)] {
        let reach = unit * 5.0;
        let mut bodies = Bodies::default();
        for (x, y) in [(0.0, 0.0), (3.0, 4.0), (-4.0, 3.0), (5.0, 0.0), (0.0, -5.0)] {
            for share in [1.0, 1.0 + 1e-15, 1.0 - 1e-15, 1.0 + 1e-9, 1.0 - 1e-9] {
                let (x, y) = (x * unit * share, y * unit * share);
                bodies.push(Particle { x, y, ..Particle::default() });
            }
        }
        let n = bodies.len();
        let right = (1..n).filter(|&j| squared(&bodies, 0, j) <= reach * reach);
        let right = right.flat_map(|j| [0.0, j as f64]).collect();
        let mut list = vec![[77; 2]; n + EIGHT];
        let len = collect(&mut list, 0, bodies.positions(), 0, 1..n, reach, AnyProcessor);
        let question = format!("particles at {reach:e} and a little more or less: within reach?");
        ask(&question, flat(&list, 0..len), right);
    }
}

/// Displacements of half a skin, and as little as possible beside it.
pub(super) fn expiry(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..100 {
        let skin = random.magnitude(1e-9, 1e3);
        let half = 0.5 * skin;
        let drawn = half * random.around_one();
        for moved in [half, half.next_up(), half.next_down(), drawn, 0.0, 2.0 * skin] {
            let question = format!(
                "skin {skin:e}, displacement {moved:e}, in units of length: has the list expired? 1 for yes, 0 for no"
            );
            ask(&question, vec![truth(expired(moved, skin))], vec![truth(moved > half)]);
        }
    }
    let none = vec![truth(expired(f64::INFINITY, 0.0))];
    ask(
        "no list yet, so an infinite displacement: has the list expired? 1 for yes",
        none,
        vec![1.0],
    );
}

/// What a step costs at the skin that is said to be cheapest, beside the cheapest of sixty.
pub(super) fn skins(random: &mut Random, ask: Ask<'_>) {
    let cost = |skin: f64, density: f64, displacement: f64| {
        let (reach, rebuilds) = (CUTOFF + skin, (2.0 * displacement / skin).min(1.0));
        let listed = 0.5 * std::f64::consts::PI * reach * reach * density;
        let tested = 0.5 * 9.0 * reach * reach * density;
        rebuilds * (REBUILD + TESTED * tested) + LISTED * listed
    };
    for case in 0..100 {
        let density = [0.0, random.magnitude(1.0, 1e7)][usize::from(case < 99)];
        let displacement = [0.0, random.magnitude(1e-4, 10.0)][usize::from(case < 98)] * CUTOFF;
        let cost = |skin: f64| cost(skin, density, displacement);
        let tried = (1..=60).map(|k| f64::from(k) * 0.05 * CUTOFF);
        let right = tried.fold(f64::INFINITY, |best, skin| {
            if cost(skin) < cost(best) || best.is_infinite() { skin } else { best }
        });
        let found = best_skin(density, displacement);
        let question = format!(
            "{density:.1} particles per area that go {:.4} cutoffs in a step: the cheapest skin, in cutoffs. With \
             yours a step costs {:.4} ns a particle, with the cheapest {:.4}",
            displacement / CUTOFF,
            cost(found),
            cost(right)
        );
        // Two skins may cost the same but for rounding.
        let as_good = (cost(found) / cost(right) - 1.0).abs() < 1e-9;
        let right = if as_good { found } else { right };
        ask(&question, vec![in_cutoffs(found)], vec![in_cutoffs(right)]);
    }
}

/// Any pairs, near or not, of particles that follow a first one.
pub(super) fn near(random: &mut Random, ask: Ask<'_>) {
    for len in random.sizes(ROOM) {
        let unit = random.magnitude(1e-6, 1e6);
        let (first, count) = (random.below(70_000), 2 + random.below(300));
        let bodies = drawn(random, count, unit);
        let positions = Positions { first, ..bodies.positions() };
        let pick = |random: &mut Random| (first + random.below(count)) as u32;
        let pairs: Vec<Pair> = (0..len).map(|_| [pick(random), pick(random)]).collect();
        // At the very distance of a pair, too.
        let within = match (len > 0).then(|| pairs[random.below(len)]) {
            Some(pair) if random.below(2) == 0 => {
                let [i, j] = pair.map(|i| i as usize - first);
                [squared(&bodies, i, j), squared(&bodies, i, j).next_down()][random.below(2)]
            }
            _ => (unit * random.between(0.1, 1.5)).powi(2),
        };
        let is_near = |pair: &&Pair| {
            let [i, j] = pair.map(|i| i as usize - first);
            squared(&bodies, i, j) <= within
        };
        let right: Vec<Pair> = pairs.iter().filter(is_near).copied().collect();
        let mut list = [[77; 2]; ROOM];
        let found = filter(&pairs, positions, within, &mut list);
        let pairs = if len == 1 { "1 pair".into() } else { format!("{len} pairs") };
        let question = format!(
            "{pairs} of {count} particles from index {first} on: those whose squared distance is {within:?} or \
                 less, in a row"
        );
        ask(&question, flat(&list, 0..found), flat(&right, 0..right.len()));
    }
}

/// The outer list of any scene, built twice, beside all pairs.
pub(super) fn outer_lists(random: &mut Random, ask: Ask<'_>) {
    for (n, size, skin) in engine_scenes(random) {
        let mut engine = Engine::<NoStatistics>::new(skin, true);
        engine.load(&scene(random, n, size * CUTOFF));
        for round in ["once", "once more"] {
            engine.inner.displacement = 0.0;
            engine.rebuild(AnyProcessor);
            let reach = CUTOFF * (1.0 + skin) * (1.0 + 1e-6);
            let must =
                |&[i, j]: &Pair| squared(&engine.bodies, i as usize, j as usize).sqrt() <= reach;
            let all = (0..n as u32).flat_map(|i| (i + 1..n as u32).map(move |j| [i, j]));
            let right: Vec<Pair> = all.filter(must).collect();
            let mut found = engine.outer.pairs.clone();
            found.sort_unstable();
            let name =
                format!("{}, box {size:.2} c, skin {skin:.2} c, listed {round}", particles(n));
            ask(
                &format!("{name}: the pairs"),
                flat(&found, 0..found.len()),
                flat(&right, 0..right.len()),
            );
            let list = &engine.outer;
            let found = vec![in_cutoffs(list.skin), list.displacement, engine.inner.displacement];
            ask(
                &format!(
                    "{name}: the skin in cutoffs, the displacement, and that of the inner list"
                ),
                found,
                vec![in_cutoffs(skin * CUTOFF), 0.0, f64::INFINITY],
            );
        }
    }
}

/// The inner list of any scene, made twice, beside the pairs of the outer one.
pub(super) fn inner_lists(random: &mut Random, ask: Ask<'_>) {
    for (n, size, fixed) in engine_scenes(random) {
        let mut engine = Engine::<NoStatistics>::new(fixed, true);
        engine.load(&scene(random, n, size * CUTOFF));
        engine.rebuild(AnyProcessor);
        for round in ["once", "once more"] {
            (engine.inner.displacement, engine.outer.displacement) = (1.0, 1e-9 * CUTOFF);
            engine.rebuild_inner();
            let (skin, found) = (inner_skin(&engine), engine.inner.skin);
            let reach = (CUTOFF + skin) * (1.0 + 1e-6);
            let near =
                |&&[i, j]: &&Pair| squared(&engine.bodies, i as usize, j as usize).sqrt() <= reach;
            let right: Vec<Pair> = engine.outer.pairs.iter().filter(near).copied().collect();
            let name =
                format!("{}, box {size:.2} c, skin {fixed:.2} c, built {round}", particles(n));
            ask(
                &format!("{name}: the skin of the inner list, in cutoffs"),
                vec![in_cutoffs(found)],
                vec![in_cutoffs(skin)],
            );
            let found = &engine.inner.pairs;
            ask(
                &format!("{name}: the inner pairs"),
                flat(found, 0..found.len()),
                flat(&right, 0..right.len()),
            );
            ask(
                &format!("{name}: the inner displacement"),
                vec![engine.inner.displacement],
                vec![0.0],
            );
        }
    }
}

/// What the skin of the inner list should be.
fn inner_skin(engine: &Engine<NoStatistics>) -> f64 {
    let left = engine.outer.skin - 2.0 * engine.outer.displacement;
    let displacement = engine.bodies.fastest() * DT;
    lasting(engine.outer.skin, displacement)
        .map_or(left, |steps| left.min(2.0 * (steps - 1.0) * displacement))
}

/// Two that are a hair further apart than cutoff and skin: rounding may have put them there.
pub(super) fn margins(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..20 {
        let skin = random.between(0.05, 3.0);
        let apart = CUTOFF * (1.0 + skin) * (1.0 + 5e-10);
        let at = |x: f64| Particle { x, y: 0.5, ..Particle::default() };
        let mut engine = Engine::<NoStatistics>::new(skin, false);
        engine.load(&Scene::new(1.0, vec![at(0.3), at(0.3 + apart)]).expect("both are inside"));
        engine.rebuild(AnyProcessor);
        engine.rebuild_inner();
        for (list, name) in [(&engine.outer, "outer"), (&engine.inner, "inner")] {
            let question = format!(
                "two particles at rest, {:.10} c apart, skin {skin:.4} c: the pairs of the {name} list (`reach` has \
                 room for rounding)",
                apart / CUTOFF
            );
            ask(&question, flat(&list.pairs, 0..list.pairs.len()), vec![0.0, 1.0]);
        }
    }
}

/// The skins of both lists, where none was asked for.
pub(super) fn chosen_skins(random: &mut Random, ask: Ask<'_>) {
    for (n, size, _) in engine_scenes(random) {
        let mut engine = Engine::<NoStatistics>::new(0.0, true);
        engine.load(&scene(random, n, size * CUTOFF));
        let extent = Extent::of(&engine.bodies);
        let density = n as f64 / ((extent.width + CUTOFF) * (extent.height + CUTOFF));
        let displacement = engine.bodies.fastest() * DT;
        let name = format!(
            "{}, box {size:.2} c, the fastest goes {:.4} c in a step",
            particles(n),
            displacement / CUTOFF
        );
        engine.rebuild(AnyProcessor);
        // A ratio: what `best_skin` says is another task's.
        let outer = engine.outer.skin;
        let found = outer / best_skin(density, displacement);
        ask(
            &format!("{name}: the skin of the outer list over the best one for this displacement"),
            vec![in_digits(found)],
            vec![1.0],
        );
        engine.outer.skin = 1.5 * CUTOFF;
        engine.rebuild_inner();
        let right = inner_skin(&engine);
        ask(
            &format!("{name}, outer skin 1.5 c: the inner skin, in cutoffs"),
            vec![in_cutoffs(engine.inner.skin)],
            vec![in_cutoffs(right)],
        );
    }
}

/// The accelerations of any scene, computed twice.
pub(super) fn accelerations(random: &mut Random, ask: Ask<'_>) {
    Engine::<NoStatistics>::new(1.0, true).accelerate();
    for (n, size, skin) in engine_scenes(random) {
        let mut engine = Engine::<NoStatistics>::new(skin, true);
        engine.load(&scene(random, n, size * CUTOFF));
        engine.rebuild(AnyProcessor);
        engine.rebuild_inner();
        for round in ["once", "once more"] {
            engine.accelerate();
            let (mut right, mut scale) = (vec![0.0; 2 * n], vec![1e-300; 2 * n]);
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|(i, j)| i != j) {
                let a = acceleration(&engine.bodies, i, j);
                for (k, a) in [(i, a.0), (n + i, a.1)] {
                    right[k] += a;
                    scale[k] += a.abs();
                }
            }
            let mut found = [&engine.ax[..], &engine.ay].concat();
            for (found, (right, scale)) in found.iter_mut().zip(right.iter().zip(&scale)) {
                *found = rounded(*found, *right, *scale);
            }
            let question = format!(
                "{}, box {size:.2} c, computed {round}: the accelerations along x of all, then along y",
                particles(n)
            );
            ask(&question, found, right);
        }
        engine.inner.pairs.clear();
        engine.accelerate();
        let question = format!("{}, no pair in the inner list: the accelerations", particles(n));
        let found = [&engine.ax[..], &engine.ay].concat();
        ask(&question, found.iter().map(|a| a.abs()).collect(), vec![0.0; 2 * n]);
    }
}

/// Numbers of particles, boxes in cutoffs and skins in cutoffs: from one cell with all to many empty ones.
fn engine_scenes(random: &mut Random) -> Vec<(usize, f64, f64)> {
    let sizes = random.sizes(257).into_iter().filter(|&n| n > 0);
    sizes
        .map(|n| {
            let crowded = random.magnitude(0.05, 20.0);
            (n, (n as f64 / crowded).sqrt().max(1.0), random.magnitude(0.05, 3.0))
        })
        .collect()
}

/// `n` particles anywhere in a box.
fn scene(random: &mut Random, n: usize, size: f64) -> Scene {
    let particle = |random: &mut Random| Particle {
        x: random.between(0.0, size),
        y: random.between(0.0, size),
        vx: random.between(-1.0, 1.0),
        vy: random.between(-1.0, 1.0),
        id: 0,
    };
    Scene::new(size, (0..n).map(|_| particle(random)).collect()).expect("all are in the box")
}

/// `n` particles anywhere in a square of a few units.
fn drawn(random: &mut Random, n: usize, unit: f64) -> Bodies {
    let side = unit * (n as f64).sqrt().clamp(1.0, 8.0);
    let mut bodies = Bodies::default();
    for id in 0..n as u32 {
        let (x, y) = (random.between(0.0, side), random.between(0.0, side));
        bodies.push(Particle { x, y, id, ..Particle::default() });
    }
    bodies
}

fn squared(bodies: &Bodies, i: usize, j: usize) -> f64 {
    let (dx, dy) = (bodies.x[j] - bodies.x[i], bodies.y[j] - bodies.y[i]);
    dx * dx + dy * dy
}

/// The model's acceleration of particle i by particle j.
fn acceleration(bodies: &Bodies, i: usize, j: usize) -> (f64, f64) {
    let d = Vec2::new(bodies.x[j] - bodies.x[i], bodies.y[j] - bodies.y[i]);
    solution1::pair_acceleration(d).map_or((0.0, 0.0), |a| (a.x, a.y))
}

fn particles(n: usize) -> String {
    if n == 1 { "1 particle".into() } else { format!("{n} particles") }
}

/// A length in cutoffs, without the digits that are rounding.
fn in_cutoffs(length: f64) -> f64 {
    in_digits(length / CUTOFF)
}

fn in_digits(number: f64) -> f64 {
    (number * 1e9).round() / 1e9
}

/// The numbers of some pairs, at most all there are.
fn flat(pairs: &[Pair], range: std::ops::Range<usize>) -> Vec<f64> {
    let pairs = pairs.get(range).unwrap_or(pairs);
    pairs.iter().flatten().map(|&i| f64::from(i)).collect()
}
