//! The least times that a program's counts allow on this machine, and the bound that limits the
//! program.

use lab_machine::core_costs;
use serde::{Deserialize, Serialize};

use crate::cachegrind::{Caches, Counts};

/// Bytes of a cache line.
const LINE: f64 = 64.0;

/// Bytes that the streaming bound reads for each particle. It writes the same number of bytes.
const STREAMED: f64 = 32.0;

/// Share of a program's time below which a bound explains nothing.
const EXPLAINS: f64 = 0.5;

/// Costs of one core of this machine, in nanoseconds.
#[derive(Clone, Copy, Deserialize, Serialize)]
pub(crate) struct Costs {
    pub(crate) instruction: f64,
    misprediction: f64,
    /// A load from the second-level cache, in a chain of dependent loads.
    second_level: f64,
    /// A load that misses the second-level cache, in a chain of dependent loads.
    beyond: f64,
    /// A multiplication or an addition.
    pub(crate) operation: f64,
}

/// Bounds on a program's time per particle and step, in nanoseconds, computed from its counts.
///
/// `instructions` and `bandwidth` are lower bounds. `branches` assumes a simple predictor and
/// `latency` assumes no prefetching, so a program may take less time than these two.
#[derive(Clone, Copy, Deserialize, Serialize)]
pub(crate) struct Bounds {
    /// Time of the instructions at the core's greatest rate.
    pub(crate) instructions: f64,
    /// Time of the branches that a simple predictor mispredicts.
    pub(crate) branches: f64,
    /// Time of the lines that miss the first-level cache, if they stream in one after another.
    pub(crate) bandwidth: f64,
    /// Time of the misses, if each miss waits for the previous miss. A program may take less time.
    pub(crate) latency: f64,
}

impl Costs {
    pub(crate) fn measure(caches: Caches) -> Self {
        let second = caches.second_level();
        Self {
            instruction: core_costs::instruction(),
            misprediction: core_costs::misprediction(),
            second_level: core_costs::latency(second / 2),
            beyond: core_costs::latency(8 * second),
            operation: core_costs::operation(),
        }
    }

    pub(crate) fn in_words(&self) -> String {
        let Self { instruction, misprediction, second_level, beyond, operation } = self;
        format!(
            "One core, at its best: {:.1} instructions a ns, {:.1} multiplications and additions of f64.\n\
             A mispredicted branch costs {misprediction:.1} ns; a load from the second level takes \
             {second_level:.1} ns, from beyond {beyond:.1} ns.",
            1.0 / instruction,
            1.0 / operation
        )
    }
}

impl Bounds {
    /// Computes the bounds from counts per particle and step.
    ///
    /// `streaming` is the measured time per particle of streaming, in nanoseconds. It determines
    /// the bandwidth of this machine.
    pub(crate) fn new(counts: Counts, costs: &Costs, streaming: f64) -> Self {
        let [instructions, first, last, mispredicted] = counts;
        Self {
            instructions: instructions * costs.instruction,
            branches: mispredicted * costs.misprediction,
            bandwidth: bytes(counts) / bandwidth(streaming),
            latency: first * costs.second_level + last * (costs.beyond - costs.second_level),
        }
    }

    /// Returns the least time of a program with these counts.
    pub(crate) fn least(&self) -> f64 {
        self.instructions.max(self.bandwidth)
    }

    /// Names the bound that limits a program that takes `time`.
    ///
    /// The bounds of branches and latency assume a simple predictor and no prefetching. They are
    /// named only if they explain why the program takes longer than the least time.
    pub(crate) fn holding(&self, time: f64) -> &'static str {
        let least = self.least();
        let rest = time - least;
        if least >= EXPLAINS * time {
            return if self.bandwidth >= least { "bandwidth" } else { "instructions" };
        }
        if self.branches >= rest {
            "branches"
        } else if self.branches + self.latency < rest {
            "not explained"
        } else if self.branches < rest / 4.0 {
            "latency"
        } else {
            "branches, latency"
        }
    }
}

/// Returns the bytes that are loaded into the first-level cache.
pub(crate) fn bytes(counts: Counts) -> f64 {
    LINE * counts[1]
}

/// Returns the bytes that streaming loads into the first-level cache in a nanosecond.
///
/// `streaming` is the time per particle of streaming, in nanoseconds.
pub(crate) fn bandwidth(streaming: f64) -> f64 {
    STREAMED / streaming
}

#[cfg(test)]
mod tests {
    use super::*;

    const COSTS: Costs = Costs {
        instruction: 0.05,
        misprediction: 5.0,
        second_level: 4.0,
        beyond: 12.0,
        operation: 0.05,
    };

    fn bounds(counts: Counts) -> Bounds {
        Bounds::new(counts, &COSTS, 0.5)
    }

    #[test]
    fn the_bound_that_holds_a_program_follows_from_its_counts() {
        let few = bounds([400.0, 3.0, 1.0, 1.0]);
        assert_eq!((few.instructions, few.branches, few.bandwidth), (20.0, 5.0, 3.0));
        assert_eq!((few.latency, few.least()), (20.0, 20.0));
        assert_eq!(few.holding(30.0), "instructions");
        assert_eq!(few.holding(50.0), "not explained");
        assert_eq!(few.holding(42.0), "latency");
        assert_eq!(bounds([400.0, 3.0, 1.0, 5.0]).holding(45.0), "branches");
        assert_eq!(bounds([400.0, 3.0, 1.0, 5.0]).holding(60.0), "branches, latency");
        assert_eq!(bounds([100.0, 30.0, 0.0, 3.0]).holding(31.0), "bandwidth");
    }
}
