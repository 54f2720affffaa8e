//! Lab 8 without a master: whole steps.

use common::hard::{Disc, Scene};
use mpi::traits::Communicator;

use super::given::{tower, zigzag};
use super::{discs, messages, ranks, tell_run};
use crate::{Answers, Random};

/// A shot through all strips, which hits a disc in the last.
fn shot(random: &mut Random) -> Scene {
    let mut discs = vec![
        Disc::new(50.0, 5.0, 0.0, 85.0),
        Disc::new(50.0 + random.between(-0.5, 0.5), 85.0, 0.0, 0.0),
    ];
    for k in 0..36 {
        let (column, row) = (f64::from(k % 4), f64::from(k / 4));
        let x = if column < 2.0 { 10.0 + 15.0 * column } else { 45.0 + 15.0 * column };
        let mut slow = || random.between(-1.0, 1.0);
        discs.push(Disc::new(x, 10.0 + 10.0 * row, slow(), slow()));
    }
    Scene::new(100.0, 1.0, discs).expect("all are inside")
}

/// Whole steps, which take all tasks from 8.8 on.
pub fn steps(random: &mut Random, answers: &mut Answers) {
    ranks::each(&ranks::counts(random), |world| {
        let [some, more] = [0; 2].map(|_| 40 + random.below(60) as u64);
        let scenes = [
            ("a tower", tower(random.between(7.0, 9.0))),
            ("a zigzag", zigzag(random.between(2.9, 3.1))),
            ("a shot through all strips", shot(random)),
            ("dense", discs(random, some, 0.4)),
            ("thin", discs(random, more, 0.2)),
        ];
        tell_run(world, answers, "spatial-cuts", &[], &scenes);
        messages::long_run(world, "spatial-cuts", &mut ranks::on_all(world, answers));
        messages::shares(world, random, "spatial-cuts", &mut ranks::on_all(world, answers));
        messages::neighbours(world, &mut ranks::on_all(world, answers));
        if world.size() > 3 {
            tell_run(world, answers, "spatial-cuts", &[("recut", 1.0)], &scenes);
        }
    });
}
