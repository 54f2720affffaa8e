//! From eight signs in a vector register to eight bits.
//!
//! Plain loops are translated for any processor ([`crate::kernels`]), but no loop over bits makes the
//! compiler use the one instruction that collects signs: it would begin at the bits that are
//! asked for, and compute what leads to each of them one by one. So here it is called by name.

use pulp::{Arch, NullaryFnOnce};

/// Numbers compared at a time.
pub const EIGHT: usize = 8;

/// A processor that collects signs.
pub trait Signs: Copy {
    /// Which of eight numbers have a minus sign: a bit for each.
    fn negative(self, numbers: &[f32; EIGHT]) -> u32;
}

/// Any processor.
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
    /// What it returns.
    type Output;

    /// The kernel. It is to be always inlined.
    fn run(self, signs: impl Signs) -> Self::Output;
}

/// A kernel translated for one processor.
struct For<S, K>(S, K);

impl<S: Signs, K: Kernel> NullaryFnOnce for For<S, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.1.run(self.0)
    }
}

/// Runs a kernel in the version that is made for this processor.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    match Arch::new() {
        #[cfg(target_arch = "x86_64")]
        Arch::V4(simd) => simd.vectorize(For(simd, kernel)),
        #[cfg(target_arch = "x86_64")]
        Arch::V3(simd) => simd.vectorize(For(simd, kernel)),
        other => other.dispatch(For(AnyProcessor, kernel)),
    }
}
