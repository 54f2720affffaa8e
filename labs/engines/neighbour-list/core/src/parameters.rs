//! The parameters of the engine as a program.

use common::{Config, Parameter};

use crate::threads::{Crew, LEAST};

/// The number of steps that an official one is divided into.
pub const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};

/// The skin of the list.
pub const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};

/// The fewest particles of a thread.
pub const SHARE: Parameter = Parameter {
    name: "share",
    about: "particles that each thread has at least; threads that would have fewer are left out",
    default: LEAST as f64,
    range: (1.0, 1e9),
};

/// The threads of a run with the parameter [`SHARE`].
pub fn crew(config: &Config) -> Crew {
    Crew::sharing(config.threads, config.parameter(SHARE.name) as usize)
}
