//! The time of a step with deep ghosts. Each rank moves the ghosts that it holds.
//!
//! No message is sent during an epoch of several steps.

use crate::blocks::{Blocks, WIRE};
use crate::network::Network;

/// Number of steps of an epoch.
///
/// This number is the mean over 100 steps of the official scene. The model uses it for all scenes,
/// although low strips have shorter epochs.
const EPOCH: f64 = 9.1;
/// Depth of the ghosts of such an epoch, in cutoffs.
const DEPTH: f64 = 12.6;

/// Reductions per epoch: one that confirms its steps, and two in every fifth epoch for load
/// balancing.
const REDUCTIONS: f64 = 1.4;

/// Numbers in the reduction that confirms steps: one for each step, and two for the plan of the
/// next epoch.
const CONFIRMED: f64 = EPOCH + 2.0;

/// Returns the time of a step of `n` particles on `p` ranks, in seconds.
///
/// A particle costs `cost` seconds. Ghosts are moved and listed, so they cost as much as the rank's
/// own particles. No particle moves while messages travel.
pub(crate) fn step(n: f64, p: f64, cost: f64, network: &Network) -> f64 {
    let blocks = Blocks::new(n, p, 1.0);
    let sides = blocks.neighbours();
    let ghosts = (sides * DEPTH * blocks.row).min(n - blocks.largest);
    // If strips are lower than ghosts are deep, the ghosts come from several strips.
    let height = blocks.largest / blocks.row;
    let partners = (2.0 * (DEPTH / height).ceil()).min(blocks.active - 1.0);
    let sent = WIRE * (ghosts + sides * EPOCH * blocks.crossing);
    let exchange = network.exchange(partners, sent / partners.max(1.0));
    let epoch = exchange.alone() + REDUCTIONS * network.all_reduce(p, CONFIRMED);
    (blocks.largest + ghosts) * cost + epoch / EPOCH
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghosts_cost_what_own_particles_cost() {
        // There are 512 strips of 138 or 139 rows, with ghosts on both sides.
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
}
