//! The time of a step with deep ghosts, which ranks move themselves: no message for an epoch of several steps.

use super::blocks::{Blocks, WIRE};
use super::network::Network;

/// Steps of an epoch, and how deep its ghosts are, in cutoffs: counted on the official scene, means of 100
/// steps. Taken for all scenes, though low strips have shorter epochs.
const EPOCH: f64 = 9.1;
const DEPTH: f64 = 12.6;

/// Reductions of an epoch: one that confirms its steps, and two in every fifth for the balance.
const REDUCTIONS: f64 = 1.4;

/// Numbers that are reduced when the steps are confirmed: one for each step and two to plan by.
const CONFIRMED: f64 = EPOCH + 2.0;

/// Seconds of a step, as [`Method::step`](super::step::Method::step). A ghost is moved and listed, and so costs
/// what an own particle costs. No particle moves while messages travel.
pub(super) fn step(n: f64, p: f64, cost: f64, network: &Network) -> f64 {
    let blocks = Blocks::new(n, p, 1.0);
    let sides = blocks.neighbours();
    let ghosts = (sides * DEPTH * blocks.row).min(n - blocks.largest);
    // Where strips are lower than ghosts are deep, they come from several.
    let height = blocks.largest / blocks.row;
    let partners = (2.0 * (DEPTH / height).ceil()).min(blocks.active - 1.0);
    let sent = WIRE * (ghosts + sides * EPOCH * blocks.crossing);
    let (busy, away) = network.exchange(partners, sent / partners.max(1.0));
    let epoch = busy + away + REDUCTIONS * network.all_reduce(p, CONFIRMED);
    (blocks.largest + ghosts) * cost + epoch / EPOCH
}

#[cfg(test)]
mod tests {
    use super::super::step::Method;
    use super::*;

    #[test]
    fn ghosts_cost_what_own_particles_cost() {
        // 512 strips of 138 or 139 rows, ghosts on both sides.
        let (n, p, cost) = (1e9, 512.0, 10e-9);
        let own = Blocks::new(n, p, 1.0).largest * cost;
        let redundant = step(n, p, cost, &Network::FREE) / own - 1.0;
        assert!((redundant - 2.0 * DEPTH / 139.0).abs() < 1e-3, "{redundant}");
    }

    #[test]
    fn no_rank_moves_more_than_all_particles() {
        for p in [2.0, 16.0, 1024.0] {
            let seconds = step(1000.0, p, 10e-9, &Network::FREE);
            assert!(seconds <= 1000.0 * 10e-9, "{p} ranks: {seconds} s");
        }
    }

    /// Where only latency counts: the positions, the word of all ranks and a list's share of its six exchanges and
    /// reductions in each step, against one exchange and 1.4 reductions an epoch.
    #[test]
    fn latency_is_paid_once_an_epoch() {
        let slow = Network { latency: 1e-3, ..Network::FREE };
        let times = |p| Method::Strips.step(1e8, p, 0.0, &slow) / step(1e8, p, 0.0, &slow);
        for p in [2.0, 8.0, 64.0] {
            assert!((8.0..10.0).contains(&times(p)), "{p} ranks: {}", times(p));
        }
    }

    /// Two ranks in memory that they share, where messages cost little, from the costs on one: the chapter's
    /// table (book/data/lab13-deep-*.json; one rank: lab13-deep-one.json and lab13-ranks-*.json).
    #[test]
    fn two_ranks_take_a_sixth_less_than_the_model_says_at_most() {
        for (n, strips_on_one, deep_on_one, measured) in
            [(1e6, 10.3, 12.6, 1.15), (1e5, 6.41, 8.43, 1.20), (1e4, 6.39, 7.72, 1.16)]
        {
            let strips = Method::Strips.step(n, 2.0, strips_on_one, &Network::FREE);
            let model = step(n, 2.0, deep_on_one, &Network::FREE) / strips;
            let off = measured / model;
            assert!((5.0 / 6.0..1.0).contains(&off), "n = {n}: {model}, measured {measured}");
        }
    }
}
