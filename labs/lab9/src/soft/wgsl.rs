//! The kernels' sources, so that a test can look at them by themselves.

/// The prefix sum.
pub fn scan() -> &'static str {
    include_str!("scan.wgsl")
}

/// The counting sort.
pub fn sort() -> &'static str {
    include_str!("sort.wgsl")
}

/// The forces.
pub fn step() -> &'static str {
    include_str!("step.wgsl")
}

/// Places in single precision.
pub fn place_f32() -> &'static str {
    include_str!("place_f32.wgsl")
}
