//! Lab 9, on a graphics processor: the solution. What the lab is about stands in `labs/lab9/README.md`.

mod candidates;
mod launch;
mod sort;

use common::{Variant, hard, soft};

/// What this lab gives to the engines: its launches ([`device::Launcher`]) and kernels
/// ([`device_discs::soft::SoftKernels`], [`device_discs::hard::HardKernels`]).
pub struct Lab9;

/// The programs of soft discs.
pub static VARIANTS: &[Variant<dyn soft::Simulation>] =
    <Lab9 as device_discs::soft::Programs>::VARIANTS;

/// The programs of hard discs.
pub static HARD_VARIANTS: &[Variant<dyn hard::Simulation>] =
    <Lab9 as device_discs::hard::Programs>::VARIANTS;
