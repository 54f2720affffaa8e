//! The programs of this lab, and their parameters.

use common::{BuildError, Config, Parameter, Reproducibility, Variant, hard, soft};

use crate::Launch;
use crate::gpu::{Gpu, GpuError, Real, Stopwatch};
use crate::hard::{Choice, Chooser, Deal, Finder, HardDiscs};
use crate::soft::{Double, Options, Precision, Single, SoftDiscs};

const WORKGROUP: Parameter = Parameter {
    name: "workgroup",
    about: "invocations in a workgroup (CUDA: threads in a block)",
    default: 64.0,
    range: (1.0, 65_536.0),
};

const TIMING: Parameter = Parameter {
    name: "timing",
    about: "1 to time each kernel by the device's clock, which makes every launch wait",
    default: 0.0,
    range: (0.0, 1.0),
};

const SOFT_PARAMETERS: &[Parameter] = &[
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

const HARD_PARAMETERS: &[Parameter] = &[
    WORKGROUP,
    Parameter {
        name: "blocks",
        about: "workgroups in the launch that finds candidates",
        default: 1080.0,
        range: (1.0, 4e9),
    },
    TIMING,
];

/// The programs of soft discs.
pub static VARIANTS: &[Variant<dyn soft::Simulation>] = &[
    Variant {
        name: "soft-f64",
        about: "soft discs in bins sorted on the device, in double precision",
        reproducibility: Reproducibility::Deterministic,
        parameters: SOFT_PARAMETERS,
        build: build_soft::<Double>,
    },
    Variant {
        name: "soft-f32",
        about: "the same in single precision, with positions relative to their bins",
        reproducibility: Reproducibility::Deterministic,
        parameters: SOFT_PARAMETERS,
        build: build_soft::<Single>,
    },
];

/// The programs of hard discs.
pub static HARD_VARIANTS: &[Variant<dyn hard::Simulation>] = &[
    hard("basic-f64", "an invocation takes a disc, and looks at all after it", |config| {
        build_hard::<f64>(config, Deal::Discs, false)
    }),
    hard("balanced-f64", "an invocation takes every T-th pair", |config| {
        build_hard::<f64>(config, Deal::Pairs, false)
    }),
    hard("basic-f32", "as basic-f64, filtered in single precision", |config| {
        build_hard::<f32>(config, Deal::Discs, false)
    }),
    hard("balanced-f32", "as balanced-f64, filtered in single precision", |config| {
        build_hard::<f32>(config, Deal::Pairs, false)
    }),
    hard(
        "chosen-f32",
        "as balanced-f32, and the device also chooses among the candidates",
        |config| build_hard::<f32>(config, Deal::Pairs, true),
    ),
];

const fn hard(
    name: &'static str,
    about: &'static str,
    build: fn(&Config) -> Result<Box<dyn hard::Simulation>, BuildError>,
) -> Variant<dyn hard::Simulation> {
    let reproducibility = Reproducibility::Bitwise;
    Variant { name, about, reproducibility, parameters: HARD_PARAMETERS, build }
}

fn refused(error: GpuError) -> BuildError {
    BuildError(error.to_string())
}

fn threads(config: &Config) -> u32 {
    config.parameter("workgroup") as u32
}

fn stopwatch(gpu: &Gpu, config: &Config) -> Option<Stopwatch> {
    if config.parameter("timing") == 0.0 { None } else { Stopwatch::new(gpu) }
}

fn build_soft<P: Precision>(config: &Config) -> Result<Box<dyn soft::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let options = Options {
        threads: threads(config),
        bin: config.parameter("bin"),
        in_flight: config.parameter("in-flight") as u32,
        statistics: config.statistics,
    };
    let engine = SoftDiscs::<P>::new(gpu, options, stopwatch(gpu, config)).map_err(refused)?;
    Ok(Box::new(engine))
}

fn build_hard<R: Real>(
    config: &Config,
    deal: Deal,
    on_device: bool,
) -> Result<Box<dyn hard::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let threads = threads(config);
    let launch = Launch::new(config.parameter("blocks") as u32, threads, &gpu.limits())
        .map_err(|error| refused(error.into()))?;
    let choice = if on_device {
        Choice::Device(Box::new(
            Chooser::new(gpu, threads, stopwatch(gpu, config)).map_err(refused)?,
        ))
    } else {
        Choice::Host
    };
    let finder = Finder::<R>::new(gpu, deal, launch, stopwatch(gpu, config)).map_err(refused)?;
    Ok(Box::new(HardDiscs::new(finder, choice)))
}
