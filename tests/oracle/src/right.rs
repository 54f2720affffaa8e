//! Comparison of an answer with the correct answer, and the kind of mistake that the difference
//! suggests.

use std::fmt::{self, Debug, Formatter};

/// A number that is printed without a decimal point if it is an integer.
#[derive(PartialEq)]
struct Plain(f64);

impl Debug for Plain {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self(number) = *self;
        if number.fract() == 0.0 && number.abs() < 1e15 {
            write!(f, "{number}")
        } else {
            write!(f, "{number:?}")
        }
    }
}

/// Compares an answer with the expected numbers.
///
/// # Errors
/// If the numbers differ: both lists (or the first different number of long lists), and the kind of
/// mistake that the difference suggests.
pub(crate) fn compare(found: &[f64], expected: &[f64]) -> Result<(), String> {
    let is_same = |k: &usize| match (found.get(*k), expected.get(*k)) {
        (Some(found), Some(expected)) => found == expected || found.is_nan() && expected.is_nan(),
        _ => false,
    };
    let most = found.len().max(expected.len());
    let Some(first) = (0..most).find(|k| !is_same(k)) else { return Ok(()) };
    let like = likeness(found, expected).map_or_else(String::new, |like| format!("{like}.\n"));
    if most <= 40 {
        let [found, expected] = [found, expected].map(plain);
        return Err(format!("{like}     found: {found:?}\n  expected: {expected:?}"));
    }
    let [found, expected] = [found, expected].map(|numbers| match numbers.get(first) {
        Some(number) => format!("{:?}", Plain(*number)),
        None => "no such number".into(),
    });
    let which = format!("number {first} of {most}, counted from 0");
    Err(format!("{like}{which}\n     found: {found}\n  expected: {expected}"))
}

fn plain(numbers: &[f64]) -> Vec<Plain> {
    numbers.iter().copied().map(Plain).collect()
}

/// Compares two tables line by line.
///
/// # Errors
/// If the tables differ: the expected table, with the different lines marked.
pub(crate) fn different_tables(found: &str, expected: &str) -> Result<(), String> {
    if found.trim_end() == expected.trim_end() {
        return Ok(());
    }
    let found: Vec<&str> = found.lines().collect();
    let expected: Vec<&str> = expected.lines().collect();
    let mut lines = Vec::new();
    for k in 0..found.len().max(expected.len()) {
        match (expected.get(k), found.get(k)) {
            (Some(expected), Some(found)) if expected == found => lines.push(format!("  {found}")),
            (expected, found) => {
                lines.extend(expected.map(|line| format!("- {line}   expected")));
                lines.extend(found.map(|line| format!("+ {line}   found")));
            }
        }
    }
    Err(lines.join("\n"))
}

/// A function that tests whether a found number and the expected number differ in a certain way.
type Difference<'a> = &'a dyn Fn(f64, f64) -> bool;

/// Names the kind of mistake that may have caused the difference. `None` if no kind fits.
fn likeness(found: &[f64], expected: &[f64]) -> Option<&'static str> {
    if found.len() > 1 && found.len() + 1 == expected.len() && expected.starts_with(found) {
        return Some("It looks as if the last number of the answer was forgotten");
    }
    let pairs = found.iter().copied().zip(expected.iter().copied());
    let pairs: Vec<(f64, f64)> = pairs.filter(|(found, expected)| found != expected).collect();
    if pairs.is_empty() || found.len() != expected.len() {
        return None;
    }
    let cut = |f: f64, e: f64, bits: i32| e.fract() == 0.0 && e >= 0.0 && f == e % 2_f64.powi(bits);
    // A small integer may be an index, so 1 is not considered half of 2.
    let is_much = |e: f64| e.fract() != 0.0 || e.abs() > 16.0;
    let all = |is: Difference| pairs.iter().all(|&(f, e)| is(f, e));
    let kinds: [(Difference, &'static str); 8] = [
        (&|f, e| cut(f, e, 8), "Each wrong number looks like a count in 8 bits"),
        (&|f, e| cut(f, e, 16), "Each wrong number looks like a count in 16 bits"),
        (&|f, e| cut(f, e, 32), "Each wrong number looks like a count in 32 bits"),
        (&|f, e| f == -e, "Each wrong number has the wrong sign"),
        (&|f, e| f == 2.0 * e && is_much(e), "Each wrong number is twice the expected number"),
        (&|f, e| 2.0 * f == e && is_much(e), "Each wrong number is half the expected number"),
        (
            &|f, e| f == f64::from(e as f32) && (f - e).abs() > 1e-12 * e.abs(),
            "Each wrong number looks as if it had been rounded to single precision",
        ),
        (
            &|f, e| (f - e).abs() <= 1e-9 * e.abs(),
            "The numbers differ in the last digits only, as after the same operations in a different order",
        ),
    ];
    kinds.iter().find(|(is, _)| all(is)).map(|(_, words)| *words)
}

#[cfg(test)]
mod tests {
    use super::{Plain, likeness};

    #[test]
    fn mistakes_look_like_their_kind() {
        for (found, expected, words) in [
            (vec![1.0, 2.0], vec![1.0, 2.0, 3.0], "last number"),
            (vec![1.0, 1.0], vec![1.0, 257.0], "8 bits"),
            (vec![1.0, 300.0], vec![65_537.0, 65_836.0], "16 bits"),
            (vec![70_000.0], vec![70_000.0 + 2_f64.powi(32)], "32 bits"),
            (vec![-0.5, 2.0], vec![0.5, 2.0], "sign"),
            (vec![f64::from(0.1_f32)], vec![0.1], "single"),
            (vec![0.1 + 1e-17 + 1e-16], vec![0.1], "last digits"),
        ] {
            let found = likeness(&found, &expected);
            assert!(found.is_some_and(|found| found.contains(words)), "{words}: {found:?}");
        }
        assert_eq!(likeness(&[7.0], &[9.0]), None);
        assert_eq!(likeness(&[1.0], &[2.0]), None, "an index");
        assert_eq!(
            likeness(&[100.0], &[200.0]),
            Some("Each wrong number is half the expected number")
        );
        let shown = format!("{:?}", [3.0, -0.5, 1e300].map(Plain));
        assert_eq!(shown, "[3, -0.5, 1e300]");
    }
}
