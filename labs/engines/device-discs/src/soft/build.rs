//! Builds the engine as a program from its parameters.

use common::{BuildError, Config, Parameter, soft};
use device::Gpu;

use super::engine::SoftDiscs;
use super::kernels::SoftKernels;
use super::positions::Precision;
use super::scene::Options;
use crate::parameters::{TIMING, WORKGROUP, refused, stopwatch, threads};

/// The parameters of each program: `workgroup`, `bin`, `in-flight`, `timing`.
pub const PARAMETERS: &[Parameter] = &[
    WORKGROUP,
    Parameter {
        name: "bin",
        about: "least side of a bin, in cutoffs",
        default: 1.0,
        range: (1.0, 3.0),
    },
    Parameter {
        name: "in-flight",
        about: "steps that may be submitted before the host waits",
        default: 1.0,
        range: (1.0, 64.0),
    },
    TIMING,
];

/// Builds an engine with the kernels `K` in precision `P` on this program's device.
///
/// # Errors
/// There is no device, or it cannot do what the parameters require.
pub fn build<K: SoftKernels, P: Precision>(
    config: &Config,
) -> Result<Box<dyn soft::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let options = Options {
        threads: threads(config),
        bin: config.parameter("bin"),
        in_flight: config.parameter("in-flight") as u32,
        statistics: config.statistics,
    };
    let engine = SoftDiscs::<K, P>::new(gpu, options, stopwatch(gpu, config)).map_err(refused)?;
    Ok(Box::new(engine))
}
