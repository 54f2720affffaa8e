//! Networks in the LogGP model.

use std::fmt;

use lab_kit::table::three_digits;
use serde::Serialize;

/// Costs of a message, in seconds.
///
/// The model is from Alexandrov, Ionescu, Schauser and Scheiman, *LogGP: incorporating long
/// messages into the LogP model*, SPAA 1995.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Network {
    /// Name of the network, and authors of the figures.
    pub(crate) name: &'static str,
    /// L: the travel time of the first byte.
    pub(crate) latency: f64,
    /// o: the time that the processor is busy with one send or one receive.
    pub(crate) overhead: f64,
    /// g: the least time between two messages of a rank.
    pub(crate) gap: f64,
    /// G: the time of each byte of a long message.
    pub(crate) per_byte: f64,
}

const MICRO: f64 = 1e-6;

/// Published figures, from the fastest network for short messages to the slowest.
pub(crate) const PUBLISHED: [Network; 3] = [
    // o is the mean of the times of a send and of a receive of one byte.
    Network {
        name: "Netgauge's printed example (ETH Zürich, htor.inf.ethz.ch/research/netgauge/loggp)",
        latency: 0.6128 * MICRO,
        overhead: 0.5 * (0.266 + 0.547) * MICRO,
        gap: 0.483 * MICRO,
        per_byte: 0.000_478 * MICRO,
    },
    Network::from_ping_pong(
        "40 Gb/s Ethernet, usNIC, Open MPI 1.8.1 (J. Squyres, blogs.cisco.com)",
        1.93 * MICRO,
        37.23e9 / 8.0,
    ),
    Network::from_ping_pong(
        "gigabit Ethernet through a switch (NW-GRID, nw-grid.ac.uk/LivMPI)",
        23.6 * MICRO,
        118.2e6,
    ),
];

/// Seconds of an exchange with other ranks.
pub(crate) struct Exchange {
    /// The part that keeps the processor busy.
    pub(crate) busy: f64,
    /// The part that does not need the processor.
    pub(crate) away: f64,
}

impl Exchange {
    /// Returns the time of an exchange during which nothing else is done.
    pub(crate) fn alone(&self) -> f64 {
        self.busy + self.away
    }

    /// Returns the time of an exchange during which the processor also works for `seconds`.
    pub(crate) fn beside(&self, seconds: f64) -> f64 {
        self.busy + (self.away - seconds).max(0.0)
    }
}

impl Network {
    /// A network whose messages cost nothing.
    #[cfg(test)]
    pub(crate) const FREE: Self =
        Self { name: "", latency: 0.0, overhead: 0.0, gap: 0.0, per_byte: 0.0 };

    /// Makes a network from half a round trip, L + 2o, and the bandwidth, if nothing else is known.
    ///
    /// It is assumed that o is a quarter of half a round trip, and that the gap equals o.
    const fn from_ping_pong(name: &'static str, half_round_trip: f64, bandwidth: f64) -> Self {
        let overhead = half_round_trip / 4.0;
        let latency = half_round_trip - 2.0 * overhead;
        Self { name, latency, overhead, gap: overhead, per_byte: 1.0 / bandwidth }
    }

    /// Returns the time of an exchange in which no message waits for another message.
    ///
    /// A rank sends a message of `bytes` bytes to each of `others` ranks and receives a message
    /// from each.
    pub(crate) fn exchange(&self, others: f64, bytes: f64) -> Exchange {
        if others == 0.0 {
            return Exchange { busy: 0.0, away: 0.0 };
        }
        let busy = others * f64::max(2.0 * self.overhead, self.gap);
        Exchange { busy, away: self.latency + others * bytes * self.per_byte }
    }

    /// Returns the time of messages from the root to each of the other ranks, or from each of them
    /// to the root, on `ranks` ranks.
    ///
    /// The messages follow one another, because the root has only one port. Together they have
    /// `bytes` bytes.
    pub(crate) fn through_root(&self, ranks: f64, bytes: f64) -> f64 {
        if ranks <= 1.0 {
            return 0.0;
        }
        let each = f64::max(self.overhead, self.gap);
        (ranks - 1.0) * each + bytes * self.per_byte + self.latency + self.overhead
    }

    /// Returns the time in which all ranks obtain the sums of `numbers` numbers with recursive
    /// doubling.
    pub(crate) fn all_reduce(&self, ranks: f64, numbers: f64) -> f64 {
        let bytes = 8.0 * numbers;
        ranks.log2().ceil() * (2.0 * self.overhead + self.latency + bytes * self.per_byte)
    }
}

/// Writes the name and the costs, in two lines.
impl fmt::Display for Network {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let times = [self.latency, self.overhead, self.gap];
        let [l, o, g] = times.map(|seconds| three_digits(seconds / MICRO));
        let per_byte = three_digits(1e9 * self.per_byte);
        write!(
            f,
            "{}:\n    L = {l} µs, o = {o} µs, g = {g} µs, G = {per_byte} ns a byte",
            self.name
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rank_alone_sends_nothing() {
        for network in PUBLISHED {
            assert_eq!(network.exchange(0.0, 100.0).alone(), 0.0);
            assert_eq!(network.through_root(1.0, 0.0), 0.0);
            assert_eq!(network.all_reduce(1.0, 1.0), 0.0);
        }
    }

    #[test]
    fn a_ping_pong_takes_what_was_published() {
        let ethernet = PUBLISHED[2];
        let half = ethernet.latency + 2.0 * ethernet.overhead;
        assert!((half - 23.6e-6).abs() < 1e-12);
        assert!((1e6 * ethernet.per_byte - 1.0 / 118.2).abs() < 1e-9);
    }

    #[test]
    fn the_root_pays_for_every_rank() {
        for network in PUBLISHED {
            let more = network.through_root(1025.0, 0.0) - network.through_root(513.0, 0.0);
            assert!((more - 512.0 * network.gap.max(network.overhead)).abs() < 1e-12);
            let doubled = network.all_reduce(1024.0, 1.0) - network.all_reduce(512.0, 1.0);
            assert!(doubled < 2.0 * (network.latency + 2.0 * network.overhead), "one more round");
        }
    }
}
