//! The engine as programs that a driver lists and builds.

use common::{BuildError, Config, Parameter, Variant, deterministic, soft};
use device::Gpu;

use super::engine::SoftDiscs;
use super::kernels::SoftKernels;
use super::positions::{Double, Precision, Single};
use super::scene::Options;
use crate::parameters::{TIMING, WORKGROUP, refused, stopwatch, threads};

/// The programs for a type that has the kernels.
pub trait Programs: SoftKernels {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn soft::Simulation>] = &[
        deterministic(
            "soft-f64",
            "soft discs in bins sorted on the device, in double precision",
            PARAMETERS,
            build::<Self, Double>,
        ),
        deterministic(
            "soft-f32",
            "the same in single precision, with positions relative to their bins",
            PARAMETERS,
            build::<Self, Single>,
        ),
    ];
}

impl<K: SoftKernels> Programs for K {}

/// The parameters of each variant: `workgroup`, `bin`, `in-flight`, `timing`.
const PARAMETERS: &[Parameter] = &[
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

/// An engine with the kernels `K` in precision `P` on this program's device.
///
/// # Errors
/// There is no device, or it cannot do what the parameters ask for.
fn build<K: SoftKernels, P: Precision>(
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
