//! Builds the engine as a program from its parameters.

use common::{BuildError, Config, Parameter, hard};
use device::{Gpu, Real};

use super::choose::{Choice, Chooser};
use super::engine::HardDiscs;
use super::finder::{Deal, Finder};
use super::kernels::HardKernels;
use crate::parameters::{TIMING, WORKGROUP, refused, stopwatch, threads};

/// The parameters of each program: `workgroup`, `blocks`, `timing`.
pub const PARAMETERS: &[Parameter] = &[
    WORKGROUP,
    Parameter {
        name: "blocks",
        about: "workgroups in the launch that finds candidates",
        default: 1080.0,
        range: (1.0, 4e9),
    },
    TIMING,
];

/// Builds an engine with the kernels `K` on this program's device, with a filter in precision `R`.
///
/// The greedy choice is made on the device if `on_device`, otherwise on the host.
///
/// # Errors
/// There is no device, or it cannot do what the parameters require.
pub fn build<K: HardKernels, R: Real>(
    config: &Config,
    deal: Deal,
    on_device: bool,
) -> Result<Box<dyn hard::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let threads = threads(config);
    let blocks = config.parameter("blocks") as u32;
    let launch = K::launch(blocks, threads, &gpu.limits()).map_err(refused)?;
    let choice = if on_device {
        let chooser = Chooser::new(gpu, threads, stopwatch(gpu, config)).map_err(refused)?;
        Choice::Device(Box::new(chooser))
    } else {
        Choice::Host
    };
    let finder = Finder::<K, R>::new(gpu, deal, launch, stopwatch(gpu, config)).map_err(refused)?;
    Ok(Box::new(HardDiscs::new(finder, choice)))
}
