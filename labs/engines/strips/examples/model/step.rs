//! The time of a step as a formula of n and p. The chapter about halos derives it.

use serde::Serialize;

use crate::blocks::{Blocks, WIRE};
use crate::deep;
use crate::network::Network;

/// Bytes of a ghost in a message.
const GHOST: f64 = 24.0;
/// Bytes of a ghost's position in a message.
const POSITION: f64 = 16.0;

/// Share of a step that computes forces, while ghosts may travel.
const FORCES: f64 = 0.5;

/// Number of steps between two tests of the load balance. Each test is an all-reduce.
const REBALANCE: f64 = 50.0;

/// Number of steps that a neighbour list lasts, counted on the official scene.
const LASTS: f64 = 9.5;
/// Width of ghosts that last for these steps, in cutoffs.
const WIDTH: f64 = 3.6;

/// Share of a step that moves inner blocks, while positions may travel.
const INNER: f64 = 0.5;

/// Number of all-reduces when lists are rebuilt.
const REDUCTIONS: f64 = 2.0;

/// A method to exchange particles between ranks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) enum Method {
    /// Gathers and scatters through the root.
    ThroughRoot,
    /// Messages to neighbours.
    Halo,
    /// A neighbour list on each rank, and ghosts that last as long as the list.
    Strips,
    /// A neighbour list on each rank, and ghosts so deep that no message is sent until the list is
    /// rebuilt.
    Deep,
}

impl Method {
    pub(crate) const ALL: [Self; 4] = [Self::ThroughRoot, Self::Halo, Self::Strips, Self::Deep];

    /// Returns the name of the variant that uses this method.
    pub(crate) fn variant(self) -> &'static str {
        match self {
            Self::ThroughRoot => "through-root",
            Self::Halo => "halo",
            Self::Strips => "strips",
            Self::Deep => "strips-deep",
        }
    }

    /// Returns the time of a step of `n` particles on `p` ranks, in seconds.
    ///
    /// A particle takes `cost` seconds on one rank.
    pub(crate) fn step(self, n: f64, p: f64, cost: f64, network: &Network) -> f64 {
        match self {
            Self::ThroughRoot => through_root(n, p, cost, network),
            Self::Halo => halo(n, p, cost, network),
            Self::Strips => strips(n, p, cost, network),
            Self::Deep => deep::step(n, p, cost, network),
        }
    }
}

/// Returns the time of two gathers and a scatter.
///
/// Counts are sent before each of the three. So the root exchanges messages with all ranks six
/// times in total.
fn through_root(n: f64, p: f64, cost: f64, network: &Network) -> f64 {
    let blocks = Blocks::new(n, p, 2.0);
    let crossing = blocks.borders() * blocks.crossing;
    let counts = 3.0 * network.through_root(p, 4.0 * (p - 1.0));
    let leavers = network.through_root(p, WIRE * crossing);
    let copies = network.through_root(p, WIRE * blocks.copies());
    // A leaver goes to its new rank and, as a ghost, back to its old rank.
    let back = network.through_root(p, WIRE * (blocks.copies() + 2.0 * crossing));
    blocks.largest * cost + counts + leavers + copies + back
}

/// Returns the time of a step whose ghosts travel while the interior is computed.
///
/// The time of movers and of a sum over all ranks is included.
fn halo(n: f64, p: f64, cost: f64, network: &Network) -> f64 {
    let blocks = Blocks::new(n, p, 1.0);
    let neighbours = blocks.neighbours();
    let counts = 2.0 * network.exchange(neighbours, 8.0).alone();
    let movers = network.exchange(neighbours, WIRE * blocks.crossing).alone();
    let interior = (blocks.largest - neighbours * blocks.row).max(0.0);
    let ghosts = network.exchange(neighbours, GHOST * blocks.row).beside(FORCES * cost * interior);
    let sums = (1.0 + 1.0 / REBALANCE) * network.all_reduce(p, 1.0);
    blocks.largest * cost + counts + ghosts + movers + sums
}

/// Returns the time of an exchange of positions while inner blocks move, and of an all-reduce.
///
/// Every few steps movers are sent and ghosts are chosen again.
fn strips(n: f64, p: f64, cost: f64, network: &Network) -> f64 {
    let blocks = Blocks::new(n, p, 1.0);
    let neighbours = blocks.neighbours();
    let ghosts = network.exchange(neighbours, POSITION * WIDTH * blocks.row);
    let positions = ghosts.beside(INNER * cost * blocks.largest);
    let lengths = 2.0 * network.exchange(neighbours, 8.0).alone();
    let movers = network.exchange(neighbours, WIRE * LASTS * blocks.crossing).alone();
    let list = lengths + movers + ghosts.alone() + REDUCTIONS * network.all_reduce(p, 1.0);
    blocks.largest * cost + positions + network.all_reduce(p, 1.0) + list / LASTS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::PUBLISHED;

    /// A network on which the time of a step in seconds equals the number of bytes.
    const BYTES: Network = Network { per_byte: 1.0, ..Network::FREE };

    #[test]
    fn one_rank_only_computes() {
        for network in &PUBLISHED {
            for method in Method::ALL {
                let step = method.step(1e6, 1.0, 30e-9, network);
                assert!((step - 0.03).abs() < 1e-12, "{method:?}: {step} s");
            }
        }
    }

    #[test]
    fn a_free_network_leaves_the_largest_block() {
        for method in [Method::ThroughRoot, Method::Halo, Method::Strips] {
            let step = method.step(1e9, 1024.0, 30e-9, &Network::FREE);
            // Blocks are whole rows, about 35 with the root's method.
            let fair = 1e9 / 1024.0 * 30e-9;
            assert!((fair..1.02 * fair).contains(&step), "{method:?}: {step} s, fair {fair} s");
        }
    }

    /// On the same scene, twice the ranks send twice the bytes through the root.
    #[test]
    fn the_roots_cost_grows_with_the_ranks() {
        let [half, all] =
            [512.0, 1024.0].map(|p| Method::ThroughRoot.step(1e9, p, 0.0, &PUBLISHED[0]));
        let ratio = all / half;
        assert!((1.98..2.01).contains(&ratio), "{ratio}");
        // The bytes grow with p √n, so four times the particles send twice the bytes.
        let [few, many] = [1e8, 4e8].map(|n| Method::ThroughRoot.step(n, 64.0, 0.0, &BYTES));
        assert!((many / few - 2.0).abs() < 0.01);
    }

    #[test]
    fn a_halo_grows_with_the_root_of_n_and_not_with_the_ranks() {
        let scenes = [(1e8, 64.0), (4e8, 64.0), (1e8, 512.0)];
        let [few, many, spread] = scenes.map(|(n, p)| Method::Halo.step(n, p, 0.0, &BYTES));
        assert!((many / few - 2.0).abs() < 0.01);
        // The sums over all ranks do not take exactly the same time.
        assert!((spread / few - 1.0).abs() < 1e-3);
    }

    /// `cargo lab traffic` counted the bytes on two ranks; the numbers are means of both ranks
    /// (book/data/lab5-traffic.json, lab6-traffic.json, lab13-traffic.json and
    /// lab13-deep-traffic.json).
    #[test]
    fn bytes_are_those_that_are_counted() {
        for (method, n, counted) in [
            (Method::Halo, 1e6, 11_183.0),
            (Method::Halo, 1e5, 3332.0),
            (Method::Strips, 1e6, 31_760.0),
            (Method::Strips, 1e5, 8_705.0),
            (Method::Deep, 1e6, 25_000.0),
            (Method::Deep, 1e5, 7_807.0),
            (Method::Deep, 1e4, 2_492.0),
            (Method::ThroughRoot, 1e6, 36_798.0),
            (Method::ThroughRoot, 1e5, 10_635.0),
        ] {
            let bytes = method.step(n, 2.0, 0.0, &BYTES);
            // The data of both ranks pass through the root, even the half that begins or ends
            // there.
            let model = if method == Method::ThroughRoot { bytes / 4.0 } else { bytes };
            let off = model / counted - 1.0;
            assert!(off.abs() < 0.1, "{method:?}, n = {n}: {model:.0} bytes, counted {counted}");
        }
    }

    #[test]
    fn ranks_without_rows_do_not_help() {
        let [few, many] =
            [64.0, 4096.0].map(|p| Method::Halo.step(1000.0, p, 30e-9, &PUBLISHED[0]));
        assert!(many > few);
    }

    /// Only latency counts here. A step of `Strips` has the positions, an all-reduce, and a share
    /// of the list's six exchanges and reductions. An epoch of `Deep` has one exchange and 1.4
    /// reductions.
    #[test]
    fn latency_is_paid_once_an_epoch() {
        let slow = Network { latency: 1e-3, ..Network::FREE };
        for p in [2.0, 8.0, 64.0] {
            let times = Method::Strips.step(1e8, p, 0.0, &slow) / deep::step(1e8, p, 0.0, &slow);
            assert!((8.0..10.0).contains(&times), "{p} ranks: {times}");
        }
    }

    /// Two ranks share their memory, so messages are cheap. The costs on one rank are from the
    /// chapter's table (book/data/lab13-deep-*.json; one rank: lab13-deep-one.json and
    /// lab13-ranks-*.json).
    #[test]
    fn two_ranks_take_a_sixth_less_than_the_model_says_at_most() {
        for (n, strips_on_one, deep_on_one, measured) in
            [(1e6, 10.3, 12.6, 1.15), (1e5, 6.41, 8.43, 1.20), (1e4, 6.39, 7.72, 1.16)]
        {
            let strips = Method::Strips.step(n, 2.0, strips_on_one, &Network::FREE);
            let model = deep::step(n, 2.0, deep_on_one, &Network::FREE) / strips;
            let off = measured / model;
            assert!((5.0 / 6.0..1.0).contains(&off), "n = {n}: {model}, measured {measured}");
        }
    }
}
