//! Formats numbers for the tables of the book.

use lab_kit::table::with_commas;

/// A number format, written in a few characters.
///
/// - `3`: three significant digits;
/// - `.2`: two decimals;
/// - `3.1`: three significant digits and at most one decimal;
/// - `2%`: per cent;
/// - `3M`: millions;
/// - `2e`: with a power of ten.
#[derive(Clone, Copy, Default)]
pub(crate) struct Format {
    digits: Option<usize>,
    decimals: Option<usize>,
    unit: Option<char>,
}

impl Format {
    /// Parses a format, which begins with a digit or a point. Returns `None` for other words.
    pub(crate) fn of(letters: &str) -> Option<Self> {
        let unit = letters.chars().last().filter(|letter| "%Me".contains(*letter));
        let numbers = letters.trim_end_matches(['%', 'M', 'e']);
        let (digits, decimals) = numbers.split_once('.').unwrap_or((numbers, ""));
        let format = Self { digits: digits.parse().ok(), decimals: decimals.parse().ok(), unit };
        (format.digits.is_some() || format.decimals.is_some()).then_some(format)
    }

    /// Formats a number: zero as `0`, thousands with commas.
    pub(crate) fn print(self, value: f64) -> String {
        if value == 0.0 {
            return "0".into();
        }
        let digits = self.digits.unwrap_or(3).max(1);
        let text = match self.unit {
            Some('e') => format!("{value:.*e}", digits - 1),
            Some('%') => format!("{} %", self.decimal(100.0 * value)),
            Some('M') => format!("{} M", without_noughts(&self.decimal(1e-6 * value))),
            _ => self.decimal(value),
        };
        text.replace('-', "−").replace("e−", "e-")
    }

    fn decimal(self, value: f64) -> String {
        let digits = self.digits.unwrap_or(3).max(1);
        let power = format!("{value:.*e}", digits - 1);
        let power = power.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
        let for_digits = usize::try_from(digits as i32 - 1 - power).unwrap_or(0);
        let decimals = match (self.digits, self.decimals) {
            (None, Some(decimals)) => decimals,
            (_, decimals) => for_digits.min(decimals.unwrap_or(for_digits)),
        };
        with_commas(&format!("{value:.decimals$}"))
    }
}

/// Removes trailing zeros after the point: `1.50` becomes `1.5`.
fn without_noughts(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::Format;

    #[test]
    fn numbers_in_each_format() {
        for (value, format, text) in [
            (12.345, "3", "12.3"),
            (0.099_96, "3", "0.100"),
            (-1_234_567.8, "3", "−1,234,568"),
            (999.6, "3", "1,000"),
            (0.0, ".2", "0"),
            (1.3034, ".3", "1.303"),
            (0.2034, "3.1", "0.2"),
            (195.4, "3.1", "195"),
            (0.0473, ".0%", "5 %"),
            (0.000_123, "2%", "0.012 %"),
            (49_995_000.0, "3M", "50 M"),
            (480_400.0, "3M", "0.48 M"),
            (-0.002_06, "2e", "−2.1e-3"),
        ] {
            assert_eq!(Format::of(format).unwrap().print(value), text);
        }
        assert!(Format::of("ms").is_none() && Format::of("%").is_none());
    }
}
