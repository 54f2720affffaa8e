//! Random numbers for the scenes of tests and probes.

/// Sizes at which programs often fail: at the ends of vector lanes, of blocks, and of the ranges of
/// eight and sixteen bits.
const SIZES: [usize; 18] =
    [0, 1, 2, 3, 7, 8, 9, 31, 32, 33, 255, 256, 257, 1025, 4097, 65_535, 65_536, 65_537];

/// A SplitMix64 generator: small, and the same on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Returns a generator that starts from any seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Draws 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Draws a number in `low` .. `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        (low + (high - low) * unit).clamp(low, high)
    }

    /// Draws an integer below `most`.
    pub fn below(&mut self, most: usize) -> usize {
        (self.bits() % most as u64) as usize
    }

    /// Draws a size up to `most`: one of [`SIZES`], or any.
    pub fn size(&mut self, most: usize) -> usize {
        let fitting = SIZES.iter().filter(|size| **size <= most).count();
        let any = self.below(fitting + 4);
        SIZES[..fitting].get(any).copied().unwrap_or_else(|| self.below(most + 1))
    }

    /// Draws a coordinate along a wall of length `size` with `along` bins. The coordinate is on the
    /// wall at either end, on an edge between bins, one rounding away from an edge, or anywhere.
    pub fn coordinate(&mut self, size: f64, along: usize) -> f64 {
        let edge = self.below(along + 1) as f64 * (size / along as f64);
        let coordinate = match self.below(8) {
            0 => 0.0,
            1 => -0.0,
            2 => size,
            3 => edge,
            4 => edge.next_up(),
            5 => edge.next_down(),
            _ => self.between(0.0, size),
        };
        // A zero keeps its sign.
        if coordinate < 0.0 { 0.0 } else { coordinate.min(size) }
    }

    /// Draws a number around 1, but not too close to 1.
    pub fn around_one(&mut self) -> f64 {
        let off = self.between(1e-6, 0.5);
        if self.below(2) == 0 { 1.0 - off } else { 1.0 + off }
    }

    /// Draws a number whose logarithm is uniform between the logarithms of `low` and `high`.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// Draws a number as [`magnitude`](Self::magnitude) does, with either sign.
    pub fn signed(&mut self, low: f64, high: f64) -> f64 {
        let magnitude = self.magnitude(low, high);
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    /// Returns all of [`SIZES`] up to `most`, and a random size. The smallest size that fails is
    /// thus found first.
    pub fn sizes(&mut self, most: usize) -> Vec<usize> {
        let mut sizes: Vec<usize> = SIZES.into_iter().filter(|&size| size <= most).collect();
        sizes.push(self.below(most + 1));
        sizes
    }

    /// Shuffles items into random order.
    pub fn shuffle<T>(&mut self, things: &mut [T]) {
        for last in (1..things.len()).rev() {
            things.swap(last, self.below(last + 1));
        }
    }
}
