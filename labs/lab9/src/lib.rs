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
//! The files with tasks are those of the table. The rest is given, and need not be read: `gpu/` (a
//! device, kernels, memory, a clock), `hard/` and `soft/` (the engines of hard and of soft discs),
//! `variants.rs` (the programs).

mod candidates;
pub mod gpu;
pub mod hard;
mod launch;
pub mod soft;
mod sort;
mod variants;

pub use launch::{Launch, checked};
pub use variants::{HARD_VARIANTS, VARIANTS};

/// The kernels' sources, so that a test can run a function of theirs by itself.
/// Functions and not constants: `cargo lab prove` chooses a known-wrong kernel while the program runs.
pub mod kernels {
    /// Which discs may collide.
    pub fn filter() -> &'static str {
        include_str!("filter.wgsl")
    }

    /// Every disc and all discs after it.
    pub fn basic() -> &'static str {
        include_str!("basic.wgsl")
    }

    /// Pairs dealt by number.
    pub fn balanced() -> &'static str {
        include_str!("balanced.wgsl")
    }

    /// The greedy choice.
    pub fn choose() -> &'static str {
        include_str!("choose.wgsl")
    }

    /// The prefix sum.
    pub fn scan() -> &'static str {
        include_str!("scan.wgsl")
    }

    /// The counting sort.
    pub fn sort() -> &'static str {
        include_str!("sort.wgsl")
    }

    /// The forces.
    pub fn forces() -> &'static str {
        include_str!("forces.wgsl")
    }

    /// Positions in single precision.
    pub fn position_f32() -> &'static str {
        include_str!("position_f32.wgsl")
    }
}
