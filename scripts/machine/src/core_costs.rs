//! Measures the costs of one core, by loops that do only one thing.

use std::hint::black_box;

use crate::nanoseconds_each;

/// Number of rounds of a timed loop.
const ROUNDS: usize = 1 << 20;

/// Bytes of a cache line.
const LINE: usize = 64;

/// Number of multiplications, and of additions, for each number that [`operation`] loads.
///
/// With this number, loads and stores take no additional time.
const STEPS: usize = 3;

/// Six numbers with different shifts, so that no two can share a vector instruction.
struct Scrambled([u64; 6]);

impl Scrambled {
    /// Number of x86-64 instructions in a round: for each number a copy, a shift and an exclusive
    /// or, three times.
    const INSTRUCTIONS: usize = 9 * 6;

    #[inline(always)]
    fn round(&mut self) {
        let [a, b, c, d, e, f] = &mut self.0;
        scramble::<13, 7, 17>(a);
        scramble::<12, 25, 27>(b);
        scramble::<11, 5, 32>(c);
        scramble::<23, 18, 5>(d);
        scramble::<21, 35, 4>(e);
        scramble::<20, 41, 6>(f);
    }
}

/// Takes a step of Marsaglia's xorshift.
#[inline(always)]
fn scramble<const A: u32, const B: u32, const C: u32>(x: &mut u64) {
    *x ^= *x << A;
    *x ^= *x >> B;
    *x ^= *x << C;
}

/// Measures the nanoseconds of an instruction at the core's greatest rate.
///
/// The instructions are independent integer operations.
pub fn instruction() -> f64 {
    nanoseconds_each(ROUNDS * Scrambled::INSTRUCTIONS, || {
        let mut numbers = black_box(Scrambled([1, 2, 3, 4, 5, 6]));
        for _ in 0..ROUNDS {
            numbers.round();
        }
        black_box(numbers);
    })
}

/// Measures the nanoseconds that a mispredicted branch costs.
///
/// A branch on a random bit is mispredicted every second time. It is compared with the same branch
/// on a bit that is always 0.
pub fn misprediction() -> f64 {
    2.0 * (branch_on(black_box(1 << 40)) - branch_on(black_box(0)))
}

/// Measures the nanoseconds of a branch on the bits of a random number under a mask.
fn branch_on(mask: u64) -> f64 {
    let mut random = 1;
    let mut taken = 0u64;
    nanoseconds_each(ROUNDS, || {
        for _ in 0..ROUNDS {
            scramble::<13, 7, 17>(&mut random);
            if random & mask != 0 {
                // Because of this call, no compiler computes the count without a branch.
                black_box(&mut taken);
            }
        }
    })
}

/// Measures the nanoseconds of a load from a random place in `bytes` bytes. Each load waits for the
/// previous load.
pub fn latency(bytes: usize) -> f64 {
    let lines = (bytes / LINE).max(2);
    let numbers = LINE / size_of::<usize>();
    // This is Sattolo's shuffle, which makes a single cycle through all lines.
    let mut order: Vec<usize> = (0..lines).collect();
    let mut random = 1;
    for last in (1..lines).rev() {
        scramble::<13, 7, 17>(&mut random);
        order.swap(last, random as usize % last);
    }
    let mut next = vec![0; lines * numbers];
    for (line, &to) in order.iter().enumerate() {
        next[line * numbers] = to * numbers;
    }
    let mut at = 0;
    nanoseconds_each(ROUNDS, || {
        for _ in 0..ROUNDS {
            at = next[at];
        }
        black_box(at);
    })
}

/// Measures the nanoseconds of a multiplication or an addition of `f64` at the core's greatest
/// rate.
///
/// Each instruction works on two numbers, as on every x86-64 processor.
pub fn operation() -> f64 {
    let (factor, summand) = black_box((0.999, 0.001));
    let mut numbers = [1.0; 512];
    nanoseconds_each(2 * ROUNDS * STEPS, || {
        for _ in 0..ROUNDS / numbers.len() {
            for number in black_box(&mut numbers) {
                for _ in 0..STEPS {
                    *number = *number * factor + summand;
                }
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cost_is_a_time() {
        for time in [instruction(), latency(1 << 14), operation()] {
            assert!(time.is_finite() && time >= 0.0, "{time}");
        }
        assert!(misprediction().is_finite());
    }
}
