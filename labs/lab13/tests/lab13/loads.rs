//! Questions about the cost of a step for a rank and for each of its rows.

use lab13::{MOVED, load, weigh_rows};
use neighbour_list::LISTED;
use oracle::{Ask, Random};

/// Draws a number of particles, of pairs, or of a row's particles.
fn count(random: &mut Random) -> u64 {
    match random.below(4) {
        0 => 0,
        1 => random.size(70_000) as u64,
        _ => random.magnitude(1.0, 1e12) as u64,
    }
}

pub(crate) fn loads(random: &mut Random, ask: &mut impl Ask) {
    for _ in 0..500 {
        let particles = count(random) as usize;
        let pairs = count(random) as usize;
        ask.exact(
            &format!("{particles} particles, {pairs} listed pairs: load in ns"),
            || vec![load(particles, pairs) as f64],
            || vec![(MOVED * particles as f64 + LISTED * pairs as f64).ceil()],
        );
    }
}

/// Asks for the shares of few and many rows. A product needs more than 64 bits.
pub(crate) fn shares(random: &mut Random, ask: &mut impl Ask) {
    for rows in random.sizes(4097).into_iter().flat_map(|rows| [rows; 5]) {
        let counts: Vec<u64> = (0..rows).map(|_| count(random)).collect();
        let counts = if random.below(6) == 0 { vec![0; rows] } else { counts };
        let load = random.magnitude(1.0, 9e18) as u64;
        let shown = if rows < 9 { format!(" with {counts:?} particles") } else { String::new() };
        let question = format!(
            "a load of {load} in {rows} rows{shown}: for each row, the upper and the lower 32 bits of its share"
        );
        ask.exact(
            &question,
            || halves(weigh_rows(&counts, load)),
            || halves(right_shares(&counts, load)),
        );
    }
}

/// Returns two halves of each share, because a floating-point number has only 53 bits.
fn halves(shares: Vec<u64>) -> Vec<f64> {
    let halves = |share: u64| [(share >> 32) as f64, f64::from(share as u32)];
    shares.into_iter().flat_map(halves).collect()
}

fn right_shares(counts: &[u64], load: u64) -> Vec<u64> {
    let all: u128 = counts.iter().map(|&count| u128::from(count)).sum();
    let share = |&count: &u64| (u128::from(load) * u128::from(count) / all.max(1)) as u64;
    counts.iter().map(share).collect()
}
