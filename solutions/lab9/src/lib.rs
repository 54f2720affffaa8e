//! Lab 9, on a graphics processor: the same physics, by thousands of invocations at once.
//!
//! A graphics processor is a machine beside the machine. It has its own memory, its own queue of
//! work, and cores by the thousand that are good at one thing: running the same function, a
//! *kernel*, on many items, next to each other and in no order. This lab drives it through wgpu,
//! with kernels in WGSL, so that one program runs on processors by NVIDIA, AMD, Intel and Apple,
//! and, where there is none, on Vulkan drivers made of software.
//!
//! You write both sides. A task in a `.wgsl` file has a comment `// todo: task 9.2: …` where the
//! answer belongs; a kernel that still contains one panics when it is built.
//!
//! Hard discs come first, as in the CS3210 report: look at all pairs, and let the host decide.
//! Soft discs follow, as in CS267's third part: bins by a counting sort, and a state that stays on
//! the device.
//!
//! | task | file | what |
//! |------|------|------|
//! | 9.1 | `launch.rs` | a launch that fits, and a refusal that is an error |
//! | 9.2 | `filter.wgsl` | which discs may collide, and a list that many append to |
//! | 9.3 | `basic.wgsl`, `candidates.rs` | every disc and all discs after it; a list that grows; the host has the last word |
//! | 9.4 | `balanced.wgsl` | pairs dealt by number |
//! | 9.5 | `choose.wgsl` | the greedy choice without a sort |
//! | 9.6 | `scan.wgsl`, `sort.rs` | prefix sums |
//! | 9.7 | `sort.wgsl`, `sort.rs`, `forces.wgsl` | a counting sort with one answer, and the forces gathered |
//! | 9.8 | `position_f32.wgsl` | positions in single precision |
//!
//! `discs.wgsl` is given: what the kernels of tasks 9.7 and 9.8 share. The device and the engines that call all
//! this are libraries, [`device`] and [`device_discs`]: `cargo doc --open -p device -p device-discs` shows what they
//! offer.

mod candidates;
mod launch;
mod sort;

use common::{BuildError, Config, Reproducibility, Variant};
use device_discs::hard::Deal;
use device_discs::soft::{Double, Single};
use device_discs::{hard, soft};

/// What this lab gives to the engines: its launches ([`device::Launcher`]) and kernels ([`soft::SoftKernels`],
/// [`hard::HardKernels`]).
pub struct Lab9;

/// The programs of soft discs.
pub static VARIANTS: &[Variant<dyn common::soft::Simulation>] = &[
    Variant {
        name: "soft-f64",
        about: "soft discs in bins sorted on the device, in double precision",
        reproducibility: Reproducibility::Deterministic,
        parameters: soft::PARAMETERS,
        build: soft::build::<Lab9, Double>,
    },
    Variant {
        name: "soft-f32",
        about: "the same in single precision, with positions relative to their bins",
        reproducibility: Reproducibility::Deterministic,
        parameters: soft::PARAMETERS,
        build: soft::build::<Lab9, Single>,
    },
];

/// The programs of hard discs.
pub static HARD_VARIANTS: &[Variant<dyn common::hard::Simulation>] = &[
    hard("basic-f64", "an invocation takes a disc, and looks at all after it", |config| {
        hard::build::<Lab9, f64>(config, Deal::Discs, false)
    }),
    hard("balanced-f64", "an invocation takes every T-th pair", |config| {
        hard::build::<Lab9, f64>(config, Deal::Pairs, false)
    }),
    hard("basic-f32", "as basic-f64, filtered in single precision", |config| {
        hard::build::<Lab9, f32>(config, Deal::Discs, false)
    }),
    hard("balanced-f32", "as balanced-f64, filtered in single precision", |config| {
        hard::build::<Lab9, f32>(config, Deal::Pairs, false)
    }),
    hard(
        "chosen-f32",
        "as balanced-f32, and the device also chooses among the candidates",
        |config| hard::build::<Lab9, f32>(config, Deal::Pairs, true),
    ),
];

const fn hard(
    name: &'static str,
    about: &'static str,
    build: fn(&Config) -> Result<Box<dyn common::hard::Simulation>, BuildError>,
) -> Variant<dyn common::hard::Simulation> {
    let (reproducibility, parameters) = (Reproducibility::Bitwise, hard::PARAMETERS);
    Variant { name, about, reproducibility, parameters, build }
}
