//! What a list costs, in nanoseconds on the machine of the book. Costs decide nothing but speed, and they
//! are constants, so that a run repeats.

/// To sort a particle and to begin looking for its pairs.
pub const REBUILD: f64 = 16.0;
/// To test a pair for the list.
pub const TESTED: f64 = 0.45;
/// To look at an entry of the list in a step.
pub const LISTED: f64 = 0.65;
