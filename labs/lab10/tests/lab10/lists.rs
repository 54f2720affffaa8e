//! Questions about the two lists of the engine, task 10.5.

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation};
use lab10::{Engine, best_skin};
use neighbour_list_core::kernels::Pair;
use neighbour_list_core::list::lasting;
use neighbour_list_core::{AnyProcessor, Bodies, Extent};
use oracle::{Ask, Near, Random, integers};

use super::scenes::{Case, flat, squared};

/// Greatest distance of a listed pair, as a multiple of the list's reach. It leaves room for
/// rounding.
const ROUNDING: f64 = 1.0 + 1e-6;

/// Asks for the outer list of any scene, built twice, and compares it with all pairs.
pub(crate) fn outer_lists(random: &mut Random, ask: &mut impl Ask) {
    for case in Case::drawn(random) {
        let mut engine = Engine::<NoStatistics>::new(case.skin, true);
        engine.load(&case.scene);
        for round in ["once", "once more"] {
            engine.inner.displacement = 0.0;
            engine.rebuild(AnyProcessor);
            let name = format!("{}, skin {:.2} cutoffs, built {round}", case.name(), case.skin);
            let question = format!(
                "{name}: (1) ids of the particles in sorted order, (2) the pairs of the outer list. A pair contains \
                 the places of its two particles in the sorted order"
            );
            let mut pairs = engine.outer.pairs.clone();
            pairs.sort_unstable();
            let found = || {
                [integers(engine.bodies.id.iter().map(|&id| id as usize)), flat(&pairs)].concat()
            };
            ask.judge(&question, found, |found| {
                let listed = Listed::read(&case.scene, found)?;
                listed.are_all_within(CUTOFF * (1.0 + case.skin))
            });
            let question = format!(
                "{name}: (1) skin of the outer list in cutoffs, (2) displacement of the outer list, (3) displacement \
                 of the inner list"
            );
            let list = &engine.outer;
            let found = || vec![list.skin / CUTOFF, list.displacement, engine.inner.displacement];
            ask.near(&question, found, || {
                [case.skin, 0.0, f64::INFINITY]
                    .map(|right| Near { right, scale: case.skin })
                    .to_vec()
            });
        }
    }
}

/// Particles in the sorted order, and pairs of positions in this order.
struct Listed {
    bodies: Bodies,
    pairs: Vec<Pair>,
}

impl Listed {
    /// Reads the ids of the particles in sorted order, and the pairs.
    fn read(scene: &Scene, found: &[f64]) -> Result<Self, String> {
        let (ids, pairs) =
            found.split_at_checked(scene.len()).ok_or("the ids of some particles are missing")?;
        let mut bodies = Bodies::default();
        for &id in ids {
            bodies.push(
                *scene
                    .particles()
                    .get(id as usize)
                    .ok_or("one of the ids belongs to no particle of the scene")?,
            );
        }
        let mut sorted = bodies.id.clone();
        sorted.sort_unstable();
        if sorted.iter().enumerate().any(|(id, &found)| id != found as usize) {
            return Err("a particle is missing".into());
        }
        let (pairs, _) = pairs.as_chunks::<2>();
        Ok(Self {
            bodies,
            pairs: pairs.iter().map(|pair| pair.map(|place| place as u32)).collect(),
        })
    }

    /// Checks that the pairs, in ascending order, are all pairs within a reach, each listed once.
    ///
    /// A pair that is at most [`ROUNDING`] farther apart may be listed.
    fn are_all_within(&self, reach: f64) -> Result<(), String> {
        let n = self.bodies.len() as u32;
        let mut all = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
        let missing = all
            .find(|&pair| self.distance(pair) <= reach && self.pairs.binary_search(&pair).is_err());
        if let Some(missing) = missing {
            return Err(format!("{} is missing", self.words(missing)));
        }
        for &[i, j] in &self.pairs {
            if !(i < j && j < n) {
                return Err(format!(
                    "[{i}, {j}] is listed, but a pair must be [i, j] with i < j < n"
                ));
            }
            if self.distance([i, j]) > reach * ROUNDING {
                return Err(format!(
                    "places {i} and {j} are listed as a pair, but their particles are too far apart"
                ));
            }
        }
        if self.pairs.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err("a pair is listed twice".into());
        }
        Ok(())
    }

    fn distance(&self, [i, j]: Pair) -> f64 {
        squared(&self.bodies, i as usize, j as usize).sqrt()
    }

    fn words(&self, pair: Pair) -> String {
        let [a, b] = pair.map(|place| self.bodies.id[place as usize]);
        let cutoffs = self.distance(pair) / CUTOFF;
        format!("the pair of particles {a} and {b}, which are {cutoffs:.4} cutoffs apart,")
    }
}

/// Asks for the inner list of any scene, built twice, and for the pairs of the outer list.
pub(crate) fn inner_lists(random: &mut Random, ask: &mut impl Ask) {
    for case in Case::drawn(random) {
        let mut engine = Engine::<NoStatistics>::new(case.skin, true);
        engine.load(&case.scene);
        engine.rebuild(AnyProcessor);
        for round in ["once", "once more"] {
            engine.inner.displacement = 1.0;
            engine.outer.displacement = 1e-9 * CUTOFF;
            engine.rebuild_inner();
            let name = format!("{}, skin {:.2} cutoffs, built {round}", case.name(), case.skin);
            let question = format!(
                "{name}: (1) ids of the particles in sorted order, (2) number of outer pairs, (3) the outer pairs, \
                 (4) the inner pairs"
            );
            ask.judge(
                &question,
                || both_lists(&engine),
                |found| are_the_near_ones(&case.scene, case.inner_skin(1e-9 * CUTOFF), found),
            );
            let question = format!(
                "{name}: (1) skin of the inner list in cutoffs, (2) displacement of the inner list"
            );
            let found = || vec![engine.inner.skin / CUTOFF, engine.inner.displacement];
            ask.near(&question, found, || {
                let right = case.inner_skin(1e-9 * CUTOFF) / CUTOFF;
                vec![Near { right, scale: case.skin }, Near { right: 0.0, scale: 0.0 }]
            });
        }
    }
}

fn both_lists(engine: &Engine<NoStatistics>) -> Vec<f64> {
    let outer = &engine.outer.pairs;
    let ids = integers(engine.bodies.id.iter().map(|&id| id as usize));
    [ids, vec![outer.len() as f64], flat(outer), flat(&engine.inner.pairs)].concat()
}

/// Checks that the inner pairs are the near pairs of the outer list, in the same order.
fn are_the_near_ones(scene: &Scene, skin: f64, found: &[f64]) -> Result<(), String> {
    let (ids, rest) =
        found.split_at_checked(scene.len()).ok_or("the ids of some particles are missing")?;
    let (count, pairs) = rest.split_first().ok_or("the lists are missing")?;
    let listed = Listed::read(scene, &[ids, pairs].concat())?;
    let (outer, inner) =
        listed.pairs.split_at_checked(*count as usize).ok_or("outer pairs are missing")?;
    let n = scene.len() as u32;
    if outer.iter().flatten().any(|&place| place >= n) {
        return Err("a place in the outer list is beyond the last particle".into());
    }
    let reach = CUTOFF + skin;
    let mut inner = inner.iter().peekable();
    for &pair in outer {
        let distance = listed.distance(pair);
        if inner.next_if_eq(&&pair).is_some() {
            if distance > reach * ROUNDING {
                return Err(format!(
                    "inner pair {pair:?} is listed, but its particles are too far apart"
                ));
            }
        } else if distance <= reach {
            return Err(format!(
                "{} is missing, or the inner pairs are in a different order",
                listed.words(pair)
            ));
        }
    }
    match inner.next() {
        Some(pair) => Err(format!(
            "inner pair {pair:?} is not an outer pair, is listed twice, or is in a wrong place"
        )),
        None => Ok(()),
    }
}

impl Case {
    /// Returns the correct skin of the inner list after a displacement.
    fn inner_skin(&self, displacement: f64) -> f64 {
        inner_skin(self.skin * CUTOFF, displacement, goes_in_a_step(&self.scene))
    }
}

/// Returns the distance that the fastest particle moves in a step.
fn goes_in_a_step(scene: &Scene) -> f64 {
    Bodies::of(scene).fastest() * DT
}

fn inner_skin(outer_skin: f64, outer_displacement: f64, goes: f64) -> f64 {
    let left = outer_skin - 2.0 * outer_displacement;
    lasting(outer_skin, goes).map_or(left, |steps| left.min(2.0 * (steps - 1.0) * goes))
}

/// Asks about two particles whose distance is slightly more than cutoff and skin, because rounding
/// may have caused this.
pub(crate) fn margins(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..20 {
        let skin = random.between(0.05, 3.0);
        let apart = CUTOFF * (1.0 + skin) * (1.0 + 5e-10);
        let at = |x: f64| Particle { x, y: 0.5, ..Particle::default() };
        let scene =
            Scene::new(1.0, vec![at(0.3), at(0.3 + apart)]).expect("both particles are in the box");
        let mut engine = Engine::<NoStatistics>::new(skin, false);
        engine.load(&scene);
        engine.rebuild(AnyProcessor);
        engine.rebuild_inner();
        let name = format!(
            "two particles at rest, {:.10} cutoffs apart, skin {skin:.4} cutoffs",
            apart / CUTOFF
        );
        for (list, which) in [(&engine.outer, "outer"), (&engine.inner, "inner")] {
            let question =
                format!("{name}: pairs of the {which} list. `reach` must leave room for rounding");
            ask.exact(&question, || flat(&list.pairs), || vec![0.0, 1.0]);
        }
    }
}

/// Asks for the skins of both lists if no skin was requested.
pub(crate) fn chosen_skins(random: &mut Random, ask: &mut impl Ask) {
    for case in Case::drawn(random) {
        let mut engine = Engine::<NoStatistics>::new(0.0, true);
        engine.load(&case.scene);
        let goes = goes_in_a_step(&case.scene);
        let extent = Extent::of(&engine.bodies);
        let density =
            case.scene.len() as f64 / ((extent.width + CUTOFF) * (extent.height + CUTOFF));
        engine.rebuild(AnyProcessor);
        let name = format!(
            "{}, the fastest particle moves {:.4} cutoffs in a step",
            case.name(),
            goes / CUTOFF
        );
        // The question asks for a ratio, because another task checks the result of `best_skin`.
        let question = format!(
            "{name}: skin of the outer list, divided by the skin that `best_skin` returns for this density and \
             displacement"
        );
        let found = || vec![engine.outer.skin / best_skin(density, goes)];
        ask.near(&question, found, || vec![Near { right: 1.0, scale: 1.0 }]);
        engine.outer.skin = 1.5 * CUTOFF;
        engine.outer.displacement = 0.0;
        engine.rebuild_inner();
        let question = format!("{name}, with an outer skin of 1.5 cutoffs: inner skin, in cutoffs");
        ask.near(
            &question,
            || vec![engine.inner.skin / CUTOFF],
            || {
                let right = inner_skin(1.5 * CUTOFF, 0.0, goes) / CUTOFF;
                vec![Near { right, scale: 1.0 }]
            },
        );
    }
}
