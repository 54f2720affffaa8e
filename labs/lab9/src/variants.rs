//! The programs of this lab, and what can be set in them.

use common::{BuildError, Knob, Promise, Settings, Variant, hard, soft};

use crate::gpu::{Gpu, GpuError, Launch, Real, Stopwatch};
use crate::hard::{Choice, Chooser, Deal, Finder, HardDiscs};
use crate::soft::{Double, Options, Precision, Single, SoftDiscs};

const WORKGROUP: Knob = Knob {
    name: "workgroup",
    about: "invocations in a workgroup (CUDA: threads in a block)",
    default: 64.0,
    range: (1.0, 65_536.0),
};

const TIMING: Knob = Knob {
    name: "timing",
    about: "1 to time each kernel by the device's clock, which makes every launch wait",
    default: 0.0,
    range: (0.0, 1.0),
};

const SOFT_KNOBS: &[Knob] = &[
    WORKGROUP,
    Knob { name: "bin", about: "least side of a bin, in cutoffs", default: 1.0, range: (1.0, 3.0) },
    Knob {
        name: "in-flight",
        about: "steps that may be submitted before the host waits",
        default: 1.0,
        range: (1.0, 64.0),
    },
    TIMING,
];

const HARD_KNOBS: &[Knob] = &[
    WORKGROUP,
    Knob {
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
        promise: Promise::Repeatable,
        knobs: SOFT_KNOBS,
        build: build_soft::<Double>,
    },
    Variant {
        name: "soft-f32",
        about: "the same in single precision, with places relative to their bins",
        promise: Promise::Repeatable,
        knobs: SOFT_KNOBS,
        build: build_soft::<Single>,
    },
];

/// The programs of hard discs.
pub static HARD_VARIANTS: &[Variant<dyn hard::Simulation>] = &[
    Variant {
        name: "basic-f64",
        about: "an invocation takes a disc, and looks at all after it",
        promise: Promise::Canonical,
        knobs: HARD_KNOBS,
        build: |settings| build_hard::<f64>(settings, Deal::Discs, false),
    },
    Variant {
        name: "balanced-f64",
        about: "an invocation takes every T-th pair",
        promise: Promise::Canonical,
        knobs: HARD_KNOBS,
        build: |settings| build_hard::<f64>(settings, Deal::Pairs, false),
    },
    Variant {
        name: "basic-f32",
        about: "as basic-f64, filtered in single precision",
        promise: Promise::Canonical,
        knobs: HARD_KNOBS,
        build: |settings| build_hard::<f32>(settings, Deal::Discs, false),
    },
    Variant {
        name: "balanced-f32",
        about: "as balanced-f64, filtered in single precision",
        promise: Promise::Canonical,
        knobs: HARD_KNOBS,
        build: |settings| build_hard::<f32>(settings, Deal::Pairs, false),
    },
    Variant {
        name: "chosen-f32",
        about: "as balanced-f32, and the device also chooses among the candidates",
        promise: Promise::Canonical,
        knobs: HARD_KNOBS,
        build: |settings| build_hard::<f32>(settings, Deal::Pairs, true),
    },
];

fn refused(error: GpuError) -> BuildError {
    BuildError(error.to_string())
}

fn threads(settings: &Settings) -> u32 {
    settings.knob("workgroup") as u32
}

fn stopwatch(gpu: &Gpu, settings: &Settings) -> Option<Stopwatch> {
    if settings.knob("timing") == 0.0 { None } else { Stopwatch::new(gpu) }
}

fn build_soft<P: Precision>(settings: &Settings) -> Result<Box<dyn soft::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let options = Options {
        threads: threads(settings),
        bin: settings.knob("bin"),
        in_flight: settings.knob("in-flight") as u32,
        statistics: settings.statistics,
    };
    let engine = SoftDiscs::<P>::new(gpu, options, stopwatch(gpu, settings)).map_err(refused)?;
    Ok(Box::new(engine))
}

fn build_hard<R: Real>(
    settings: &Settings,
    deal: Deal,
    on_device: bool,
) -> Result<Box<dyn hard::Simulation>, BuildError> {
    let gpu = Gpu::shared().map_err(refused)?;
    let threads = threads(settings);
    let launch = Launch::new(settings.knob("blocks") as u32, threads, &gpu.limits())
        .map_err(|error| refused(error.into()))?;
    let choice = if on_device {
        Choice::Device(Box::new(
            Chooser::new(gpu, threads, stopwatch(gpu, settings)).map_err(refused)?,
        ))
    } else {
        Choice::Host
    };
    let finder = Finder::<R>::new(gpu, deal, launch, stopwatch(gpu, settings)).map_err(refused)?;
    Ok(Box::new(HardDiscs::new(finder, choice)))
}
