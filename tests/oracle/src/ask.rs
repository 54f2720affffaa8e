//! What questions have in common, in tests and in probes.

/// Gets a question, what the lab answers and what is right.
pub type Ask<'a> = &'a mut dyn FnMut(&str, Vec<f64>, Vec<f64>);

/// Whole numbers as an answer.
pub fn whole(numbers: impl IntoIterator<Item = usize>) -> Vec<f64> {
    numbers.into_iter().map(|number| number as f64).collect()
}

/// 1 where it is so, 0 where not.
pub fn truth(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// That for each.
pub fn flags<'a>(all: impl IntoIterator<Item = &'a bool>) -> Vec<f64> {
    all.into_iter().map(|&is| truth(is)).collect()
}

/// A number and its two neighbours in floating point.
pub fn beside(number: f64) -> [f64; 3] {
    [number, number.next_down(), number.next_up()]
}

/// What was found; what is right, if they differ by no more than sums of numbers that add up to `scale` may.
pub fn rounded(found: f64, right: f64, scale: f64) -> f64 {
    if (found - right).abs() <= 1e-12 * scale { right } else { found }
}

/// A list as its length and two sums, of its items' numbers by their index and of their ids: lists may be long.
pub fn digest(items: impl IntoIterator<Item = (f64, u64)>) -> Vec<f64> {
    let mut told = vec![0.0; 3];
    for (number, id) in items {
        told[0] += 1.0;
        told[1] += told[0] * number;
        told[2] += id as f64;
    }
    told
}
