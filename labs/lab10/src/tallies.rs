//! What is counted.

/// What windows count.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tallies {
    /// Windows.
    pub(crate) windows: u64,
    /// Neighbour lists built for windows.
    pub(crate) lists: u64,
    /// Pairs looked at.
    pub(crate) tests: u64,
    /// Particles that flew freely through a window.
    pub(crate) flown: u64,
    /// Particles moved, one for each step of those in groups and one for each window of the free.
    pub(crate) touched: u64,
    /// Particles computed again.
    pub(crate) repaired: u64,
    /// Windows redone: with half the steps, or on a list with more pairs watched.
    pub(crate) redone: u64,
    /// Particles that might have reached a wall.
    pub(crate) walls: u64,
}
