//! The parameters that both engines have.

use common::{BuildError, Config, Parameter};
use device::{Gpu, Stopwatch};

/// The number of invocations in a workgroup.
pub(crate) const WORKGROUP: Parameter = Parameter {
    name: "workgroup",
    about: "invocations in a workgroup (CUDA: threads in a block)",
    default: 64.0,
    range: (1.0, 65_536.0),
};

/// Whether kernels are timed.
pub(crate) const TIMING: Parameter = Parameter::switch(
    "timing",
    "1 to time each kernel by the device's clock, which makes every launch wait",
    false,
);

/// Returns the value of [`WORKGROUP`].
pub(crate) fn threads(config: &Config) -> u32 {
    config.parameter("workgroup") as u32
}

/// Returns a clock, if [`TIMING`] is on and the device has a clock.
pub(crate) fn stopwatch(gpu: &Gpu, config: &Config) -> Option<Stopwatch> {
    if config.parameter("timing") == 0.0 { None } else { Stopwatch::new(gpu) }
}

/// Converts an error into the error of a program that cannot be built.
pub(crate) fn refused(error: impl ToString) -> BuildError {
    BuildError(error.to_string())
}
