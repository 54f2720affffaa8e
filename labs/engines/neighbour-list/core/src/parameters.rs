//! The command-line parameters of the engine.

use common::{Config, Parameter};

use crate::threads::{Crew, LEAST};

/// The number of small steps in an official step.
pub const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};

/// The skin of the list, in cutoffs.
pub const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};

/// The least number of particles for each thread.
pub const SHARE: Parameter = Parameter {
    name: "share",
    about: "particles that each thread has at least; threads that would have fewer are left out",
    default: LEAST as f64,
    range: (1.0, 1e9),
};

/// Whether the engine measures the parts of each step.
pub const TIMING: Parameter =
    Parameter::switch("timing", "1: measure the parts of a step, for --breakdown", false);

/// Returns the threads of a run, according to `config` and the parameter [`SHARE`].
pub fn crew(config: &Config) -> Crew {
    Crew::sharing(config.threads, config.parameter(SHARE.name) as usize)
}
