//! Questions about the filter: the pairs that it passes on, and the list of these pairs.

use std::collections::BTreeSet;

use common::hard::{Disc, RandomScene, Scene};
use device::{Gpu, Real};
use oracle::{Ask, Random, hard, integers};
use solution7::pair_hit;

use super::adapter::{adapter, adapter_with_doubles};
use super::launched::{ALL_PAIRS, Search, touching};

pub(super) fn numbers(all: &[[u32; 2]]) -> Vec<f64> {
    all.as_flattened().iter().map(|number| f64::from(*number)).collect()
}

/// Returns the pairs that these numbers represent.
pub(super) fn pairs_of(numbers: &[f64]) -> Vec<[u32; 2]> {
    let (pairs, _) = numbers.as_chunks();
    pairs.iter().map(|pair: &[f64; 2]| pair.map(|number| number as u32)).collect()
}

/// Returns all pairs a < b of `n` discs.
pub(super) fn all_pairs(n: u32) -> impl Iterator<Item = [u32; 2]> {
    (0..n).flat_map(move |a| (a + 1..n).map(move |b| [a, b]))
}

/// Draws `n` discs of radius 1 on a part of the square, with speeds up to `speed`.
pub(super) fn drawn(random: &mut Random, n: u64, fraction: f64, speed: f64) -> Scene {
    let side = (n as f64 * std::f64::consts::PI / fraction).sqrt();
    let seed = 1 + random.below(1_000_000_000) as u32;
    let scene = RandomScene::new(n, side, 1.0, seed).with_speeds(speed / 4.0, speed);
    scene.draw().expect("the scene is valid")
}

/// Discs whose collisions the filter must find.
struct Filtered {
    name: String,
    scene: Scene,
    /// Whether only few other pairs may be passed on. If discs graze each other or touch, many may
    /// be.
    strict: bool,
}

impl Filtered {
    /// Returns scenes of all kinds, and random scenes.
    fn all(random: &mut Random) -> Vec<Self> {
        let named = hard::scenes::all().into_iter().map(|(name, scene)| {
            let strict = ["crowded", "overfull", "thin", "fast"].contains(&name);
            Self { name: name.into(), scene, strict }
        });
        let mut all: Vec<Self> = named.collect();
        for (least, fraction, speed) in [(80, 0.3, 2.0), (120, 0.6, 1.0), (120, 0.02, 10.0)] {
            let n = least + random.below(60) as u64;
            let scene = drawn(random, n, fraction, speed);
            let name = format!("discs on {fraction} of the square");
            all.push(Self { name, scene, strict: true });
        }
        all
    }

    fn ask<R: Real>(&self, gpu: &Gpu, ask: &mut impl Ask) {
        let n = self.scene.len();
        let question = format!(
            "scene '{}' of {n} discs, in {}: number of pairs counted, then both discs of each pair in the list",
            self.name,
            std::any::type_name::<R>()
        );
        let found = || {
            let search = Search { room: (n * n) as u64, ..Search::of(&self.scene, ALL_PAIRS) };
            let mut found = search.run::<R>(gpu);
            found.list.sort_unstable();
            [vec![f64::from(found.count)], numbers(&found.list)].concat()
        };
        ask.judge(&question, found, |found| self.verdict(found));
    }

    /// Checks that all pairs that collide are passed on, each pair once, and few other pairs.
    fn verdict(&self, found: &[f64]) -> Result<(), String> {
        let Some((count, pairs)) = found.split_first() else {
            return Err("the answer is empty".into());
        };
        let pairs = pairs_of(pairs);
        if *count as usize != pairs.len() {
            return Err(format!("{count} pairs are counted, but {} are in the list", pairs.len()));
        }
        let different: BTreeSet<_> = pairs.iter().copied().collect();
        if different.len() < pairs.len() {
            return Err("a pair is in the list more than once".into());
        }
        let scene = &self.scene;
        let meet = |[a, b]: [u32; 2]| pair_hit(scene.discs(), a, b, scene.radius()).is_some();
        let colliding: Vec<_> = all_pairs(scene.len() as u32).filter(|&pair| meet(pair)).collect();
        if let Some([a, b]) = colliding.iter().find(|pair| !different.contains(*pair)) {
            return Err(format!("discs {a} and {b} collide, but their pair is not passed on"));
        }
        let others = different.len() - colliding.len();
        if self.strict && others > colliding.len() / 20 + 2 {
            return Err(format!(
                "{others} pairs that do not collide are passed on, in addition to the {} pairs that collide",
                colliding.len()
            ));
        }
        Ok(())
    }
}

pub(crate) fn filter_in_single(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.2") else { return };
    Filtered::all(random).iter().for_each(|filtered| filtered.ask::<f32>(gpu, ask));
}

pub(crate) fn filter_in_double(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter_with_doubles("9.2") else { return };
    Filtered::all(random).iter().for_each(|filtered| filtered.ask::<f64>(gpu, ask));
}

/// Asks about touching pairs that single precision cannot distinguish from separating pairs.
pub(crate) fn slow_contacts(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.2") else { return };
    let scene = touching(|| random.between(0.0, std::f64::consts::TAU));
    let question = "100 slow contacts, of discs 0 and 1, of discs 2 and 3, and so on, in single precision: both discs \
                    of each contact in the list";
    let found = || {
        let search = Search { room: 10_000, ..Search::of(&scene, ALL_PAIRS) };
        let mut list = search.run::<f32>(gpu).list;
        list.retain(|[a, b]| a / 2 == b / 2);
        list.sort_unstable();
        numbers(&list)
    };
    ask.exact(question, found, || (0..200).map(f64::from).collect());
}

/// Asks about pairs at the bounds of the filter, and beyond them. All numbers are exact in single
/// precision.
pub(crate) fn at_the_bounds(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.2") else { return };
    let pair = |x: f64, y: f64, d: [f64; 2], vx: f64| {
        [Disc::new(x, y, 0.0, 0.0), Disc::new(x + d[0], y + d[1], vx, 0.0)]
    };
    let discs = [
        pair(1.0, 1.0, [4.0, 0.0], 0.0),
        pair(1.0, 8.0, [0.0, 4.25], 0.0),
        pair(9.0, 3.0, [0.5, 0.0], 1.0 / 2048.0),
        pair(9.0, 12.0, [0.5, 0.0], 1.0 / 1024.0),
    ];
    let scene = Scene::new(16.0, 0.1, discs.concat()).expect("all discs are inside the square");
    let question = "four pairs: discs 0 and 1 at the distance 1/4, discs 2 and 3 at the distance 17/64, discs 4 and 5 \
                    with d · D = 2^-20, discs 6 and 7 with d · D = 2^-19. The bounds are reach_squared = 1/16 and \
                    receding = 2^-20: both discs of each of these pairs that is in the list";
    let found = || {
        let bounds = Some([0.0625, 1.0 / (1 << 20) as f32]);
        let mut list = Search { bounds, ..Search::of(&scene, ALL_PAIRS) }.run::<f32>(gpu).list;
        list.retain(|[a, b]| a / 2 == b / 2);
        list.sort_unstable();
        numbers(&list)
    };
    ask.exact(question, found, || integers([0, 1, 4, 5]));
}

/// Asks about more pairs than the list has room for, and about a number that fills the list.
pub(crate) fn a_full_list(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.2") else { return };
    // A device allocates memory for two pairs at a time, so an even number of pairs fills it
    // exactly.
    let n = 80 + 4 * random.below(10) as u64;
    let scene = drawn(random, n, 0.3, 2.0);
    let all = n * (n - 1) / 2;
    for room in [2 + 2 * random.below(50) as u64, all] {
        let question = format!(
            "{all} pairs, and a list with room for {room} pairs: (1) number of pairs counted, (2) number of pairs in \
             the list, (3) number of different pairs in the list, (4) number of pairs written behind the end of the \
             list"
        );
        let found = || {
            let search = Search { room, everything: true, ..Search::of(&scene, ALL_PAIRS) };
            let found = search.run::<f32>(gpu);
            let different: BTreeSet<_> = found.list.iter().filter(|[a, b]| a < b).collect();
            let lengths = integers([found.list.len(), different.len(), found.beyond]);
            [vec![f64::from(found.count)], lengths].concat()
        };
        ask.exact(&question, found, || vec![all as f64, room as f64, room as f64, 0.0]);
    }
}
