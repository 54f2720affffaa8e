//! Timing programs, judging the times, and showing them.

#[allow(dead_code)]
pub(crate) mod chart;
