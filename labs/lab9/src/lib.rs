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
//! | 9.1 | `gpu/launch.rs`, `gpu/kernel.rs` | a launch that fits, and a refusal that is an error |
//! | 9.2 | `hard/filter.wgsl` | which discs may collide, and a list that many append to |
//! | 9.3 | `hard/basic.wgsl`, `hard/finder.rs`, `hard/engine.rs` | every disc and all discs after it; a list that grows; the host has the last word |
//! | 9.4 | `hard/balanced.wgsl` | pairs dealt by number |
//! | 9.5 | `hard/choose.wgsl` | the greedy choice without a sort |
//! | 9.6 | `soft/scan.wgsl`, `soft/scan.rs` | prefix sums |
//! | 9.7 | `soft/sort.wgsl`, `soft/engine.rs`, `soft/step.wgsl` | a counting sort with one answer, and the forces gathered |
//! | 9.8 | `soft/place_f32.wgsl` | places in single precision |

pub mod gpu;
pub mod hard;
pub mod soft;
mod variants;

pub use variants::{HARD_VARIANTS, VARIANTS};
