//! The kernels' sources, so that a test can run a function of theirs by itself.

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
