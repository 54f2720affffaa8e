//! Questions about the pairs that a whole search finds: tasks 7.9, 7.10, 7.12 and 7.13.

use std::collections::BTreeSet;

use common::hard::Scene;
use hard_discs::{
    Candidate, Collect, Deal, Entry, Find, Found, Grid, Hit, LockedCount, Loops, Planned, Schedule,
    SharedCount, Slots, Span, Square, Team, Which, Window, Workers,
};
use lab7::{Lab7, append_atomic, append_locked, block_of, inner, nested, outer, partners};
use oracle::hard::{What, possible, scenes};
use oracle::{Ask, Random};

/// Returns a team of `count` threads.
fn workers(count: usize) -> Workers {
    Workers::new(count).expect("the threads start")
}

/// Asks which pairs of a scene a finder finds.
fn finds(
    ask: &mut impl Ask,
    name: &str,
    (scene_name, scene): (&str, &Scene),
    finder: impl FnOnce() -> Box<dyn Find>,
) {
    let question = format!(
        "{name}, scene '{scene_name}' of {} discs: both discs of each pair that is found (-1 for none)",
        scene.len()
    );
    ask.judge(&question, || found_by(&mut *finder(), scene), |found| all_pairs(scene, found));
}

/// Returns the pairs that a finder finds, in as many windows as the finder chooses.
fn found_by(finder: &mut dyn Find, scene: &Scene) -> Vec<f64> {
    let square = Square::of(scene);
    let windows = finder.windows(scene.discs(), square);
    let mut pairs = Vec::new();
    for k in 0..windows {
        let mut found = Found::default();
        found.clear(1);
        let free = vec![true; scene.len()];
        finder.find(scene.discs(), &free, square, Window::part(k, windows), &mut found);
        let hits = found.lists.iter().flatten().map(|candidate| candidate.hit);
        pairs.extend(
            hits.flat_map(|hit| [hit.first().into(), hit.second().map_or(-1.0, f64::from)]),
        );
    }
    pairs
}

/// Checks that these are the pairs that collide, each pair once, with the lower disc first.
fn all_pairs(scene: &Scene, found: &[f64]) -> Result<(), String> {
    let discs = scene.discs();
    let mut missing = BTreeSet::new();
    for event in possible(discs, scene.side(), scene.radius()) {
        if let What::Disc(other) = event.what {
            missing.insert((event.disc, other));
        }
    }
    let expected = missing.clone();
    for pair in found.as_chunks::<2>().0 {
        let (a, b) = (pair[0] as usize, pair[1] as usize);
        if pair[0] >= pair[1] {
            return Err(format!(
                "discs {} and {} are in the wrong order: the disc with the lower number comes first in a pair",
                pair[0], pair[1]
            ));
        }
        if !expected.contains(&(a, b)) {
            return Err(format!("discs {a} and {b} are found, but do not collide"));
        }
        if !missing.remove(&(a, b)) {
            return Err(format!("the pair of discs {a} and {b} is found twice"));
        }
    }
    match missing.first() {
        Some(&(a, b)) => Err(format!(
            "discs {a} and {b} collide, but are not found: {:?} and {:?}",
            discs[a], discs[b]
        )),
        None => Ok(()),
    }
}

/// Asks the programs of task 7.9 for every pair.
pub(crate) fn pairs_of_loops(_: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    outer(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    inner(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    nested(2, Team::Fresh(1), Schedule::Static, |_, _, _| ());
    for (name, scene) in scenes::all().into_iter().filter(|(_, scene)| scene.len() <= 400) {
        for which in [Which::Outer, Which::Inner, Which::Nested] {
            finds(ask, &format!("{which:?} loop by 2 threads"), (name, &scene), || {
                let queue = Schedule::Dynamic { chunk: 7 };
                Box::new(Loops::<Lab7>::new(which, queue, Collect::Own, workers(2)))
            });
        }
    }
}

/// Asks for the pairs of searches that append to one shared list.
pub(crate) fn pairs_in_one_list(_: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    let pair = Candidate { time: 0.5, hit: Hit::Pair(0, 1) };
    append_locked(&Slots::default(), &LockedCount::default(), pair);
    append_atomic(&Slots::default(), &SharedCount::default(), pair);
    for (name, scene) in scenes::all() {
        for collect in [Collect::Locked, Collect::Atomic] {
            finds(ask, &format!("one list, {collect:?}, of 3 threads"), (name, &scene), || {
                let queue = Schedule::Dynamic { chunk: 1 };
                Box::new(Loops::<Lab7>::new(Which::Outer, queue, collect, workers(3)))
            });
        }
    }
}

/// Asks the grid for every pair.
pub(crate) fn pairs_of_grid(_: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    let corner = Span { low: 1.0, high: 2.0 };
    block_of(corner, corner, 16.0);
    for (name, scene) in scenes::all() {
        for deal in [Deal::Discs(3), Deal::Blocks] {
            finds(ask, &format!("grid, 3 threads share {deal:?}"), (name, &scene), || {
                Box::new(Grid::<Lab7>::new(workers(3), deal))
            });
        }
    }
}

/// Asks sorted cells for every pair, in any number of windows.
pub(crate) fn pairs_of_cells(_: &mut Random, ask: &mut impl Ask) {
    // Calls this task's function first, so that an unsolved starter stops at this task's `todo!`.
    partners(&[Entry::new(0, 0, 0, true)], 0);
    for (name, scene) in scenes::all() {
        for windows in [1, 2, 7, 64] {
            finds(ask, &format!("cells in {windows} windows"), (name, &scene), || {
                Box::new(Planned::<Lab7>::new(Workers::One, Some(windows)))
            });
        }
    }
}
