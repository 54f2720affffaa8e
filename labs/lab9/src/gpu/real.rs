//! The numbers that kernels compute with.

use bytemuck::Pod;

/// `real` in WGSL: f32 or f64.
pub trait Real: Pod + Into<f64> + Send + Sync + 'static {
    /// What `real` is, in WGSL.
    const ALIAS: &'static str;

    /// Whether the device must compute in double precision.
    const DOUBLE: bool;

    /// The greatest relative error of rounding once.
    const ROUNDING: f64;

    /// The nearest such number; the greatest one, if `value` is beyond it.
    fn of(value: f64) -> Self;
}

impl Real for f64 {
    const ALIAS: &'static str = "alias real = f64;\n";
    const DOUBLE: bool = true;
    const ROUNDING: f64 = f64::EPSILON / 2.0;

    fn of(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    const ALIAS: &'static str = "alias real = f32;\n";
    const DOUBLE: bool = false;
    const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

    fn of(value: f64) -> Self {
        value.clamp(f64::from(Self::MIN), f64::from(Self::MAX)) as Self
    }
}
