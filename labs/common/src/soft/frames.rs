//! Writes positions in the format of the original program.

use std::io::{self, Write};

use super::Particle;

/// The format of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameFormat {
    /// `x y` with six significant digits, as C++ streams print doubles.
    Official,
    /// `x y vx vy`, with enough digits to read the same numbers back.
    Full,
}

/// Writes a run: one line `n size`, then for each frame one line per particle and an empty line.
pub struct FrameWriter<W> {
    out: W,
    format: FrameFormat,
}

impl<W: Write> FrameWriter<W> {
    /// Writes the first line.
    ///
    /// # Errors
    /// Writing to `out` fails.
    pub fn new(mut out: W, format: FrameFormat, n: usize, size: f64) -> io::Result<Self> {
        match format {
            FrameFormat::Official => writeln!(out, "{n} {}", general(size))?,
            FrameFormat::Full => writeln!(out, "{n} {size:?}")?,
        }
        Ok(Self { out, format })
    }

    /// Writes the next particles of a frame.
    ///
    /// # Errors
    /// Writing to `out` fails.
    pub fn particles(&mut self, particles: &[Particle]) -> io::Result<()> {
        for Particle { x, y, vx, vy, .. } in particles {
            match self.format {
                FrameFormat::Official => writeln!(self.out, "{} {}", general(*x), general(*y))?,
                FrameFormat::Full => writeln!(self.out, "{x:?} {y:?} {vx:?} {vy:?}")?,
            }
        }
        Ok(())
    }

    /// Ends a frame.
    ///
    /// # Errors
    /// Writing to `out` fails.
    pub fn end_frame(&mut self) -> io::Result<()> {
        writeln!(self.out)
    }
}

/// Formats a number as C's `%g` does: with six significant digits and without trailing zeros.
///
/// The format has an exponent if the number is below 1e-4 or has more than six digits before the
/// point.
pub fn general(value: f64) -> String {
    const DIGITS: i32 = 6;
    if !value.is_finite() {
        return value.to_string().to_lowercase();
    }
    // Rounding comes first: 999999.5 has exponent 6, not 5.
    let scientific = format!("{value:.*e}", DIGITS as usize - 1);
    let (mantissa, exponent) = scientific.split_once('e').expect("format {:e} has an exponent");
    let exponent: i32 = exponent.parse().expect("an exponent is an integer");
    if (-4..DIGITS).contains(&exponent) {
        trimmed(&format!("{value:.*}", (DIGITS - 1 - exponent) as usize)).to_owned()
    } else {
        let sign = if exponent < 0 { '-' } else { '+' };
        format!("{}e{sign}{:02}", trimmed(mantissa), exponent.abs())
    }
}

fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

#[cfg(test)]
mod tests {
    use super::general;

    #[test]
    fn numbers_look_like_those_of_c() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (0.1 + 0.2, "0.3"),
            (0.123_456_78, "0.123457"),
            (0.000_123_456_789, "0.000123457"),
            (0.000_012_345, "1.2345e-05"),
            (123_456.0, "123456"),
            (999_999.5, "1e+06"),
            (99_999.97, "100000"),
            (1.5e-300, "1.5e-300"),
            (-2.5e10, "-2.5e+10"),
        ] {
            assert_eq!(general(value), text, "{value:e}");
        }
    }
}
