//! Hard discs: a crowd of them, and discs and their collisions as numbers.

use common::hard::{Disc, RandomScene, Scene};

// Of lab 7, as the lab that is asked has it.
use super::Hit;
use crate::Random;

/// `n` discs of radius 1 on a part of the square, with velocity components between these sizes.
pub fn crowd(random: &mut Random, n: u64, fraction: f64, speeds: [f64; 2]) -> Scene {
    let side = (n as f64 * std::f64::consts::PI / fraction).sqrt();
    let seed = 1 + random.below(1_000_000_000) as u32;
    let scene = RandomScene::new(n, side, 1.0, seed).with_speeds(speeds[0], speeds[1]);
    scene.draw().expect("the scene is sound")
}

/// x y vx vy of a disc, and its collisions with discs and with walls.
pub fn state(disc: &Disc) -> [f64; 6] {
    let counts = [disc.pair_collisions, disc.wall_collisions].map(f64::from);
    [disc.x, disc.y, disc.vx, disc.vy, counts[0], counts[1]]
}

/// What is hit: 0 to 3 for a corner, an x wall, a y wall, a pair, and which discs.
pub fn hit(hit: Hit) -> [f64; 3] {
    match hit {
        Hit::Corner(a) => [0.0, f64::from(a), -1.0],
        Hit::WallX(a) => [1.0, f64::from(a), -1.0],
        Hit::WallY(a) => [2.0, f64::from(a), -1.0],
        Hit::Pair(a, b) => [3.0, f64::from(a), f64::from(b)],
    }
}
