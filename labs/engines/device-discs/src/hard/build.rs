//! The engine as programs that a driver lists and builds.

use common::{BuildError, Config, Parameter, Reproducibility, Variant, hard};
use device::{Gpu, Real};

use super::choose::{Choice, Chooser};
use super::engine::HardDiscs;
use super::finder::{Deal, Finder};
use super::kernels::HardKernels;
use crate::parameters::{TIMING, WORKGROUP, refused, stopwatch, threads};

/// The programs for a type that has the kernels.
pub trait Programs: HardKernels {
    /// All of them. They give the same bits on every device.
    const VARIANTS: &'static [Variant<dyn hard::Simulation>] = &[
        variant("basic-f64", "an invocation takes a disc, and looks at all after it", |config| {
            build::<Self, f64>(config, Deal::Discs, false)
        }),
        variant("balanced-f64", "an invocation takes every T-th pair", |config| {
            build::<Self, f64>(config, Deal::Pairs, false)
        }),
        variant("basic-f32", "as basic-f64, filtered in single precision", |config| {
            build::<Self, f32>(config, Deal::Discs, false)
        }),
        variant("balanced-f32", "as balanced-f64, filtered in single precision", |config| {
            build::<Self, f32>(config, Deal::Pairs, false)
        }),
        variant(
            "chosen-f32",
            "as balanced-f32, and the device also chooses among the candidates",
            |config| build::<Self, f32>(config, Deal::Pairs, true),
        ),
    ];
}

impl<K: HardKernels> Programs for K {}

const fn variant(
    name: &'static str,
    about: &'static str,
    build: fn(&Config) -> Result<Box<dyn hard::Simulation>, BuildError>,
) -> Variant<dyn hard::Simulation> {
    let (reproducibility, parameters) = (Reproducibility::Bitwise, PARAMETERS);
    Variant { name, about, reproducibility, parameters, build }
}

/// The parameters of each variant: `workgroup`, `blocks`, `timing`.
const PARAMETERS: &[Parameter] = &[
    WORKGROUP,
    Parameter {
        name: "blocks",
        about: "workgroups in the launch that finds candidates",
        default: 1080.0,
        range: (1.0, 4e9),
    },
    TIMING,
];

/// An engine with the kernels `K` on this program's device, which filters in precision `R`. The greedy choice
/// is made `on_device` or on the host.
///
/// # Errors
/// There is no device, or it cannot do what the parameters ask for.
fn build<K: HardKernels, R: Real>(
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
