//! Free flight.

/// Advances free flyers by `steps` steps, with the very additions of step by step: one rounding
/// for each step, but one visit for all of them.
#[inline(always)]
pub fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64) {
    todo!("task 11.1: free flight")
}
