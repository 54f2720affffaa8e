//! Collects the signs of eight numbers in a vector register as eight bits.
//!
//! Processors have one instruction for this, but no loop over bits makes the compiler use it: the
//! compiler begins with the result and computes each bit separately. So this module names the
//! instruction explicitly. All other kernels are plain loops ([`crate::kernels`]).

use pulp::{Arch, NullaryFnOnce};

/// Number of values that are compared at a time.
pub const EIGHT: usize = 8;

/// A processor's way to collect signs.
pub trait Signs: Copy {
    /// Returns a bit for each of eight numbers: 1 if the number has a minus sign.
    fn negative(self, numbers: &[f32; EIGHT]) -> u32;
}

/// Any processor, without a special instruction.
#[derive(Clone, Copy)]
pub struct AnyProcessor;

impl Signs for AnyProcessor {
    #[inline(always)]
    fn negative(self, numbers: &[f32; EIGHT]) -> u32 {
        numbers.iter().enumerate().map(|(l, x)| (x.to_bits() >> 31) << l).sum()
    }
}

#[cfg(target_arch = "x86_64")]
impl Signs for pulp::x86::V3 {
    #[inline(always)]
    fn negative(self, numbers: &[f32; EIGHT]) -> u32 {
        self.avx._mm256_movemask_ps(pulp::bytemuck::cast(*numbers)) as u32
    }
}

#[cfg(target_arch = "x86_64")]
impl Signs for pulp::x86::V4 {
    #[inline(always)]
    fn negative(self, numbers: &[f32; EIGHT]) -> u32 {
        self.avx._mm256_movemask_ps(pulp::bytemuck::cast(*numbers)) as u32
    }
}

/// A vector kernel that collects signs.
pub trait Kernel {
    /// The result of the kernel.
    type Output;

    /// Runs the kernel. Implementations must be `#[inline(always)]`.
    fn run(self, signs: impl Signs) -> Self::Output;
}

/// A kernel, to be translated for one processor.
struct For<S, K>(S, K);

impl<S: Signs, K: Kernel> NullaryFnOnce for For<S, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.1.run(self.0)
    }
}

/// Runs the version of a kernel that fits this processor.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    match Arch::new() {
        #[cfg(target_arch = "x86_64")]
        Arch::V4(simd) => simd.vectorize(For(simd, kernel)),
        #[cfg(target_arch = "x86_64")]
        Arch::V3(simd) => simd.vectorize(For(simd, kernel)),
        other => other.dispatch(For(AnyProcessor, kernel)),
    }
}
