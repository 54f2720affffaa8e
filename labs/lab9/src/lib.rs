#![doc = include_str!("../README.md")]

mod candidates;
mod launch;
mod sort;

use common::{Variant, bitwise, deterministic, hard, soft};
use device_discs::hard::{Deal, PARAMETERS, build};
use device_discs::soft::{Double, Single};

/// The launches ([`device::Launcher`]) and kernels of this lab, which the engines use.
///
/// The kernels are [`device_discs::soft::SoftKernels`] and [`device_discs::hard::HardKernels`].
pub struct Lab9;

/// The programs of soft discs.
pub static VARIANTS: &[Variant<dyn soft::Simulation>] = &[
    deterministic(
        "soft-f64",
        "soft discs in bins sorted on the device, in double precision",
        device_discs::soft::PARAMETERS,
        device_discs::soft::build::<Lab9, Double>,
    ),
    deterministic(
        "soft-f32",
        "the same in single precision, with positions relative to their bins",
        device_discs::soft::PARAMETERS,
        device_discs::soft::build::<Lab9, Single>,
    ),
];

/// The programs of hard discs.
pub static HARD_VARIANTS: &[Variant<dyn hard::Simulation>] = &[
    bitwise(
        "basic-f64",
        "an invocation takes a disc, and looks at all after it",
        PARAMETERS,
        |config| build::<Lab9, f64>(config, Deal::Discs, false),
    ),
    bitwise("balanced-f64", "an invocation takes every T-th pair", PARAMETERS, |config| {
        build::<Lab9, f64>(config, Deal::Pairs, false)
    }),
    bitwise("basic-f32", "as basic-f64, filtered in single precision", PARAMETERS, |config| {
        build::<Lab9, f32>(config, Deal::Discs, false)
    }),
    bitwise(
        "balanced-f32",
        "as balanced-f64, filtered in single precision",
        PARAMETERS,
        |config| build::<Lab9, f32>(config, Deal::Pairs, false),
    ),
    bitwise(
        "chosen-f32",
        "as balanced-f32, and the device also chooses among the candidates",
        PARAMETERS,
        |config| build::<Lab9, f32>(config, Deal::Pairs, true),
    ),
];
