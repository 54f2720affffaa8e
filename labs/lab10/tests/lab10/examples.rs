//! The worked examples: a few particles that can be checked by hand, and the lab's results.

use std::f64::consts::PI;

use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
use lab10::{Engine, best_skin, collect, drift, expired, filter};
use neighbour_list_core::kernels::{Pair, ROOM};
use neighbour_list_core::{AnyProcessor, Bodies, Positions};
use oracle::{Ask, Count, Random, Table, spaced};

use super::forces::no_forces;

pub(crate) fn drift_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["call", "index", "x", "v", "a", "v after", "x after"]);
        let mut calls = Table::new(["call", "is any outside?"]);
        let a = [0.4, 0.0, -0.4, 0.8];
        for (call, x) in [(1, [0.5, 0.25, 0.75]), (2, [0.5, 0.875, 0.75])] {
            let v = [0.0, 0.5, 0.2, 0.1];
            let mut after_x = x;
            let mut after_v = v;
            let outside = drift(&mut after_x, &mut after_v, &a, 0.5, 1.0);
            calls.row([&call, &if outside { "yes" } else { "no" }]);
            for k in 0..4 {
                let [x, after_x] =
                    [x, after_x].map(|x| x.get(k).map_or("-".into(), |x| format!("{x:.3}")));
                table.row([&call, &k, &x, &v[k], &a[k], &format!("{:.2}", after_v[k]), &after_x]);
            }
        }
        format!("{table}\n{calls}")
    });
}

/// Returns particles on a line at these positions.
fn in_a_row(places: impl IntoIterator<Item = f64>) -> Bodies {
    let mut bodies = Bodies::default();
    for (id, x) in (0..).zip(places) {
        bodies.push(Particle { x, id, ..Particle::default() });
    }
    bodies
}

/// Shows the pairs of a dozen particles in a row whose distances increase.
pub(crate) fn pairs_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let bodies = in_a_row((0..12).map(|id| (0.3 + 0.05 * f64::from(id * id)) * CUTOFF));
        let mut table = Table::new(["particle", "x / cutoff", "reach 1", "reach 1.5", "reach 2"]);
        for i in 0..12 {
            let [one, more, most] = [1.0, 1.5, 2.0].map(|cutoffs| {
                let mut list = [[77; 2]; 12 + 8];
                let reach = cutoffs * CUTOFF;
                let positions = bodies.positions();
                let len = collect(&mut list, 0, positions, i, i + 1..12, reach, AnyProcessor);
                spaced(list[..len].iter().map(|[_, j]| j))
            });
            table.row([&i, &format!("{:.2}", bodies.x[i] / CUTOFF), &one, &more, &most]);
        }
        table.to_string()
    });
}

pub(crate) fn expiry_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["displacement", "skin", "expired?"]);
        for displacement in [0.0, 0.24, 0.25, 0.26, 0.49, 3.0, f64::INFINITY] {
            let is = if expired(displacement, 0.5) { "yes" } else { "no" };
            table.row([&displacement, &0.5, &is]);
        }
        table.to_string()
    });
}

pub(crate) fn skins_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["neighbours", "0.01 c", "0.03 c", "0.05 c", "0.1 c", "0.3 c"]);
        for neighbours in [0.1, 0.63, 2.0, 10.0, 60.0] {
            let density = neighbours / (PI * CUTOFF * CUTOFF);
            let [a, b, c, d, e] = [0.01, 0.03, 0.05, 0.1, 0.3]
                .map(|goes| format!("{:.2}", best_skin(density, goes * CUTOFF) / CUTOFF));
            table.row([&neighbours, &a, &b, &c, &d, &e]);
        }
        table.to_string()
    });
}

/// Shows the filter on four particles from index 10 on.
pub(crate) fn filter_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let bodies = in_a_row([0.0, 1.0, 3.0, 4.5]);
        let positions = Positions { first: 10, ..bodies.positions() };
        let pairs: [Pair; 5] = [[10, 11], [10, 12], [11, 12], [10, 13], [12, 13]];
        let mut table = Table::new(["pair", "x of the one", "x of the other"]);
        for pair in pairs {
            let [x, other] = pair.map(|i| bodies.x[i as usize - 10]);
            table.row([&spaced(pair), &x, &other]);
        }
        let mut near = [[0; 2]; ROOM];
        let mut found = Table::new(["squared distance at most", "how many", "near"]);
        for squared in [0.5, 3.0, 4.0] {
            let len = filter(&pairs, positions, squared, &mut near);
            found.row([&squared, &len, &with_commas(near[..len].iter().map(spaced))]);
        }
        format!("{table}\n{found}")
    });
}

/// Shows the lists of five particles on a line with a skin of one cutoff: the list has a reach of
/// two cutoffs.
pub(crate) fn lists_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let places = [1.0, 1.8, 2.6, 4.4, 6.9];
        let particles =
            places.map(|x| Particle { x: x * CUTOFF, y: CUTOFF, vx: 1.0, ..Particle::default() });
        let mut engine = Engine::<NoStatistics>::new(1.0, true);
        engine.load(
            &Scene::new(8.0 * CUTOFF, particles.to_vec()).expect("all particles are in the box"),
        );
        let mut table = Table::new(["", "pairs of particles", "skin / cutoff", "displacement"]);
        engine.rebuild(AnyProcessor);
        let skin = |list: &lab10::List| format!("{:.2}", list.skin / CUTOFF);
        let outer = &engine.outer;
        table.row([
            &"`rebuild`: outer list",
            &of_ids(&engine, outer),
            &skin(outer),
            &outer.displacement,
        ]);
        table.row([&"           inner list", &"not yet", &"-", &engine.inner.displacement]);
        engine.rebuild_inner();
        let inner = &engine.inner;
        table.row([
            &"`rebuild_inner`: inner list",
            &of_ids(&engine, inner),
            &skin(inner),
            &inner.displacement,
        ]);
        table.to_string()
    });
}

/// Lists the pairs of a list by the ids of the particles.
fn of_ids(engine: &Engine<NoStatistics>, list: &lab10::List) -> String {
    let ids = list.pairs.iter().map(|pair| {
        let mut ids = pair.map(|place| engine.bodies.id[place as usize]);
        ids.sort_unstable();
        ids
    });
    let mut ids: Vec<[u32; 2]> = ids.collect();
    ids.sort_unstable();
    with_commas(ids.iter().map(spaced))
}

fn with_commas(pairs: impl Iterator<Item = String>) -> String {
    let pairs: Vec<String> = pairs.collect();
    if pairs.is_empty() { "-".into() } else { pairs.join(", ") }
}

/// Shows the forces on four particles, of which the last is alone.
pub(crate) fn forces_table(_: &mut Random, ask: &mut impl Ask) {
    no_forces();
    ask.example(|| {
        let places = [(1.7, 0.5), (1.2, 0.5), (1.7, 1.2), (3.5, 3.5)];
        let at = |(x, y)| Particle { x: x * CUTOFF, y: y * CUTOFF, ..Particle::default() };
        let mut engine = Engine::<Count>::new(1.0, true);
        engine.load(
            &Scene::new(4.0 * CUTOFF, places.map(at).to_vec())
                .expect("all particles are in the box"),
        );
        engine.rebuild(AnyProcessor);
        engine.rebuild_inner();
        let mut table =
            Table::new(["computed", "particle", "x / cutoff", "y / cutoff", "ax", "ay"]);
        for round in ["once", "once more"] {
            engine.accelerate();
            for (id, (x, y)) in (0..).zip(places) {
                let place = engine.bodies.id.iter().position(|&found| found == id);
                let place = place.expect("the list contains every particle");
                // Negative zero becomes zero.
                let [ax, ay] = [&engine.ax, &engine.ay].map(|a| format!("{:.1}", a[place] + 0.0));
                table.row([&round, &id, &x, &y, &ax, &ay]);
            }
        }
        table.to_string()
    });
}

/// Shows two particles that fly towards each other, each by 0.05 cutoffs in a step. The list
/// expires when each may have moved by half of the skin.
pub(crate) fn steps_table(_: &mut Random, ask: &mut impl Ask) {
    no_forces();
    ask.example(|| {
        let at = |x: f64, vx: f64| Particle { x: x * CUTOFF, y: 0.05, vx, ..Particle::default() };
        let scene = Scene::new(0.1, vec![at(3.0, 1.0), at(4.6, -1.0)])
            .expect("both particles are in the box");
        let mut engine = Engine::<NoStatistics>::new(0.37, true);
        engine.load(&scene);
        let mut table = Table::new([
            "after step",
            "apart",
            "outer pairs",
            "outer displacement",
            "inner displacement",
        ]);
        for step in 1..=9 {
            engine.step();
            let apart = (engine.bodies.x[1] - engine.bodies.x[0]).abs();
            let [apart, outer, inner] =
                [apart, engine.outer.displacement, engine.inner.displacement]
                    .map(|x| format!("{:.2}", x / CUTOFF));
            table.row([&step, &apart, &engine.outer.pairs.len(), &outer, &inner]);
        }
        table.to_string()
    });
}
