//! What tests and probe ask alike about the host's last word, with drawn inputs.

use common::hard::Disc;
use device_discs::hard::{HardKernels, WALL};
use lab9::Lab9;
use solution7::{Candidate, Square, pair_hit, wall_hit};

use super::ask::Ask;
use crate::Random;

/// Time, first disc, second disc or -1 of each.
fn values(candidates: &[Candidate]) -> Vec<f64> {
    let second = |c: &Candidate| c.hit.second().map_or(-1.0, f64::from);
    candidates.iter().flat_map(|c| [c.time, f64::from(c.hit.first()), second(c)]).collect()
}

/// What a device passed on, one list after the other into the same candidates: more, fewer, none, with pairs and walls
/// that collide or not.
pub(super) fn confirmed(random: &mut Random, ask: Ask<'_>) {
    let mut candidates = Vec::new();
    for n in random.sizes(4097).into_iter().chain([257, 1, 0]) {
        let square = Square { side: 3.0 * (n as f64 + 4.0).sqrt(), radius: 1.0 };
        let discs: Vec<Disc> = (0..n + 2)
            .map(|_| {
                let mut coordinate = || random.between(1.0, square.side - 1.0);
                let (x, y) = (coordinate(), coordinate());
                Disc::new(x, y, random.signed(1e-3, 8.0), random.signed(1e-3, 8.0))
            })
            .collect();
        let found: Vec<[u32; 2]> = (0..n)
            .map(|_| {
                let (a, b) = (random.below(n + 2) as u32, random.below(n + 2) as u32);
                if a == b || random.below(3) == 0 { [a, WALL] } else { [a.min(b), a.max(b)] }
            })
            .collect();
        let right: Vec<Candidate> = found
            .iter()
            .filter_map(|&[a, b]| match b {
                WALL => wall_hit(a, &discs[a as usize], square),
                b => pair_hit(&discs, a, b, square.radius),
            })
            .collect();
        let before = candidates.len();
        Lab9::confirm(&discs, square, &found, &mut candidates);
        let question = format!(
            "a device passed on {n}, and {before} candidates stand there from before: time, first disc, second disc or -1 \
             of each that is confirmed"
        );
        ask(&question, values(&candidates), values(&right));
    }
}
