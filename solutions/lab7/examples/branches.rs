//! Measures a branch that a processor cannot predict, in the test of a pair of discs: `cargo run
//! --release -p solution7 --example branches`.
//!
//! Half of all pairs approach each other, in no order that a processor could predict. `pair_time`
//! has a branch for this condition. A second form of the test computes both conditions of a
//! collision before its first branch. Nearly all pairs fail one of the conditions, so this branch
//! can be predicted.

use std::time::Instant;

use common::SceneError;
use common::hard::{Disc, RandomScene};
use solution7::pair_time;

/// Number of discs; every pair is tested.
const DISCS: u64 = 4000;
/// Side of the square.
const SIDE: f64 = 20_000.0;
/// Radius of a disc.
const RADIUS: f64 = 1.0;
/// Number of rounds; both forms take turns.
const ROUNDS: usize = 9;

fn main() -> Result<(), SceneError> {
    let scene = RandomScene::new(DISCS, SIDE, RADIUS, 1).draw()?;
    let discs = scene.discs();
    let all = DISCS * (DISCS - 1) / 2;
    let meeting = count(discs, |a, b| pair_time(a, b, RADIUS).is_some());
    println!("{all} pairs: {} approach, {meeting} meet in a step", count(discs, approach));
    let mut each = Vec::new();
    let mut both = Vec::new();
    for _ in 0..ROUNDS {
        each.push(time(discs, meeting, |a, b| pair_time(a, b, RADIUS).is_some()));
        both.push(time(discs, meeting, |a, b| joined(a, b, RADIUS).is_some()));
    }
    println!("ns for the test of a pair, least (median) of {ROUNDS}:");
    for (name, mut times) in [("a branch for each condition", each), ("one branch for both", both)]
    {
        times.sort_by(f64::total_cmp);
        println!("  {name:27}  {:.2} ({:.2})", times[0], times[ROUNDS / 2]);
    }
    Ok(())
}

/// Whether two discs approach each other.
fn approach(a: &Disc, b: &Disc) -> bool {
    (b.position() - a.position()).dot(b.velocity() - a.velocity()) < 0.0
}

/// Returns what `pair_time` returns, and has one branch for both conditions.
fn joined(a: &Disc, b: &Disc, radius: f64) -> Option<f64> {
    let d = b.position() - a.position();
    let velocity = b.velocity() - a.velocity();
    let s = d.dot(velocity);
    let cross = d.cross(velocity);
    let (distance, reach) = (d.norm_squared(), 4.0 * radius * radius);
    let delta = reach * velocity.norm_squared() - cross * cross;
    let overlap = distance <= reach;
    // The operator | computes both sides; || would branch.
    if (s >= 0.0) | !((delta > 0.0) | overlap) {
        return None;
    }
    if overlap {
        return Some(0.0);
    }
    let time = (distance - reach) / (delta.sqrt() - s);
    (time < 1.0).then_some(time)
}

/// Returns the number of pairs for which `test` is true.
fn count(discs: &[Disc], test: impl Fn(&Disc, &Disc) -> bool) -> u64 {
    let mut count = 0;
    for (k, a) in discs.iter().enumerate() {
        count += discs[k + 1..].iter().filter(|b| test(a, b)).count() as u64;
    }
    count
}

/// Returns the nanoseconds that `test` takes for a pair; it must be true for `meeting` pairs.
fn time(discs: &[Disc], meeting: u64, test: impl Fn(&Disc, &Disc) -> bool) -> f64 {
    let start = Instant::now();
    assert_eq!(count(discs, test), meeting, "both forms find the same pairs");
    let pairs = discs.len() * (discs.len() - 1) / 2;
    start.elapsed().as_secs_f64() * 1e9 / pairs as f64
}
