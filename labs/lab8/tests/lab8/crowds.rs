//! Scenes of whole runs: the oracle's scenes, and scenes that are hard for ranks.

use std::f64::consts::PI;

use common::hard::{Disc, RandomScene, Scene};
use oracle::Random;
use oracle::hard::scenes;

/// Returns the oracle's scenes, scenes that are hard for ranks, and random scenes.
pub(crate) fn all_scenes(random: &mut Random) -> Vec<(&'static str, Scene)> {
    let mut all = scenes::all();
    // Two scenes are added: all discs in the lowest hundredth of the square, and all discs on one
    // line, where strips have no height.
    let low: Vec<_> = (0..40).map(|k| (2.0 * f64::from(k) + 5.0, 1.0, 1.5, 0.2)).collect();
    all.push(("all in one strip", scenes::of(100.0, 1.0, &low)));
    let line: Vec<_> =
        (0..30).map(|k| (3.0 * f64::from(k) + 5.0, 50.0, f64::from(k % 3) - 1.0, 0.0)).collect();
    all.push(("all on one line", scenes::of(100.0, 1.0, &line)));
    all.push(("a tower", tower(8.0)));
    all.push(("two discs", scenes::of(10.0, 1.0, &[(3.0, 3.0, 2.0, 2.0), (7.0, 7.0, -2.0, -2.0)])));
    all.extend(drawn_scenes(random));
    all
}

/// Draws scenes.
fn drawn_scenes(random: &mut Random) -> Vec<(&'static str, Scene)> {
    vec![
        ("a tower of other speeds", tower(random.between(7.0, 9.0))),
        ("a shot through all strips", shot(random)),
        ("dense", crowd(random, 0.4)),
        ("thin", crowd(random, 0.2)),
    ]
}

/// Returns a tower. Each disc flies into the disc above it, across every cut. The lowest disc has
/// speed 44 / `slow`.
fn tower(slow: f64) -> Scene {
    let disc = |k: u32| Disc::new(50.0, 2.2 * f64::from(k) + 1.0, 0.0, f64::from(44 - k) / slow);
    Scene::new(100.0, 1.0, (0..45).map(disc).collect()).expect("all discs are inside the square")
}

/// Returns a chain of discs along the middle of a square that crosses the middle repeatedly. Each
/// disc flies into the next disc, and nearly all meet at the same time, the first two first. So the
/// outcome for a disc depends on the disc behind it. The chain crosses the cut in the middle at
/// every other disc, so a decision takes 122 rounds.
pub(crate) fn zigzag(slow: f64) -> Scene {
    let disc = |k: u32| {
        let i = f64::from(k);
        let up = [-1.5, 0.0, 1.5, 0.0][k as usize % 4];
        Disc::new(5.0 + 1.61 * i + 5e-5 * i * i, 200.0 + up + 1e-6 * i, (240.0 - i) / slow, 0.0)
    };
    Scene::new(400.0, 1.0, (0..240).map(disc).collect()).expect("all discs are inside the square")
}

/// Draws a disc that flies through all strips and hits a disc in the last strip.
fn shot(random: &mut Random) -> Scene {
    let mut discs = vec![
        Disc::new(50.0, 5.0, 0.0, 85.0),
        Disc::new(50.0 + random.between(-0.5, 0.5), 85.0, 0.0, 0.0),
    ];
    for k in 0..36 {
        let column = f64::from(k % 4);
        let row = f64::from(k / 4);
        let x = if column < 2.0 { 10.0 + 15.0 * column } else { 45.0 + 15.0 * column };
        let mut slow = || random.between(-1.0, 1.0);
        discs.push(Disc::new(x, 10.0 + 10.0 * row, slow(), slow()));
    }
    Scene::new(100.0, 1.0, discs).expect("all discs are inside the square")
}

/// Draws 40 to 99 discs of radius 1 with speeds up to 3, on a part of the square.
fn crowd(random: &mut Random, fraction: f64) -> Scene {
    let n = 40 + random.below(60) as u64;
    let side = (n as f64 * PI / fraction).sqrt();
    let seed = 1 + random.below(1_000_000_000) as u32;
    let scene = RandomScene::new(n, side, 1.0, seed).with_speeds(0.5, 3.0);
    scene.draw().expect("the scene is valid")
}

/// Draws 300 to 499 discs with speeds up to 3.
pub(crate) fn wide(random: &mut Random) -> Scene {
    let n = 300 + random.below(200) as u64;
    let seed = 1 + random.below(1 << 30) as u32;
    let scene = RandomScene::new(n, 100.0, 1.0, seed).with_speeds(0.5, 3.0);
    scene.draw().expect("the scene is valid")
}
