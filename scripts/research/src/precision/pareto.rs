//! Who is beaten by nobody in both time and error.

/// Whether each point (cost, error) lies on the Pareto front: no other is as good in both and
/// better in one. What is not finite is never on it.
pub(super) fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    let beats = |a: &(f64, f64), b: &(f64, f64)| {
        finite(a) && a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
    };
    points.iter().map(|p| finite(p) && !points.iter().any(|other| beats(other, p))).collect()
}

#[cfg(test)]
mod tests {
    use super::front;

    #[test]
    fn the_front_is_what_nobody_beats() {
        let points = [(1.0, 9.0), (2.0, 5.0), (2.0, 6.0), (3.0, 5.0), (4.0, 1.0), (0.5, f64::NAN)];
        assert_eq!(front(&points), [true, true, false, false, true, false]);
    }

    #[test]
    fn equals_share_the_front() {
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [true, true]);
    }
}
