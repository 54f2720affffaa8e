//! The grading rules of the original autograder: complexity by slope, scaling by efficiency.
//!
//! The course reports do not state the rules, but they print grades. The tests of
//! [`published`](crate::published) compute the same grades from the times that the reports print.

use super::clock::Span;

/// Returns the slope of the least-squares line through (ln x, ln y): the exponent b of y ∝ xᵇ.
///
/// NaN if there are fewer than two different x; points must be positive.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
    let over: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let under: f64 = logs.iter().map(|(x, _)| (x - mean_x).powi(2)).sum();
    over / under
}

/// Returns two slopes: one for the shortest takes, and one for the medians.
pub fn slopes(points: &[(f64, Span)]) -> Span {
    Span::both(|way| slope(&points.iter().map(|(x, y)| (*x, way(y))).collect::<Vec<_>>()))
}

/// Grades a program whose time grows as n to the power `slope`.
pub fn complexity_grade(slope: f64) -> f64 {
    match slope {
        b if b < 1.3 => 100.0,
        b if b < 1.5 => 75.0 + (1.5 - b) / 0.2 * 25.0,
        b if b < 2.0 => (2.0 - b) / 0.5 * 75.0,
        _ => 0.0,
    }
}

/// Returns the strong-scaling efficiency: the speed-up of all workers divided by their number.
///
/// The arguments are the seconds of one worker and of all workers on the same scene.
pub fn strong_efficiency(one: f64, workers: usize, all: f64) -> f64 {
    one / (workers as f64 * all)
}

/// Returns the weak-scaling efficiency. It is the time of one worker divided by the time of all
/// workers on a larger scene.
///
/// The scene grows in proportion to the number of workers.
pub fn weak_efficiency(one: f64, all: f64) -> f64 {
    one / all
}

/// Averages efficiencies over the numbers of workers, for the shortest takes and for the medians.
///
/// The efficiency of one worker is included. Returns `None` if there are no efficiencies.
pub fn averages(efficiencies: &[Span]) -> Option<Span> {
    let count = efficiencies.len() as f64;
    (count > 0.0).then(|| Span::both(|way| efficiencies.iter().map(way).sum::<f64>() / count))
}

/// Grades an average efficiency.
pub fn efficiency_grade(average: f64) -> f64 {
    match average {
        e if e > 0.8 => 100.0,
        e if e > 0.5 => 75.0 + 25.0 * (e - 0.5) / 0.3,
        e => 150.0 * e,
    }
}

/// Grades a parallel program. The grade is the average of two grades: for the mean strong-scaling
/// efficiency and for the mean weak-scaling efficiency.
pub fn scaling_grade(strong: f64, weak: f64) -> f64 {
    0.5 * (efficiency_grade(strong) + efficiency_grade(weak))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-6, "{a} against {b}");
    }

    #[test]
    fn grades_are_continuous_where_the_rule_changes() {
        for edge in [1.3, 1.5, 2.0] {
            near(complexity_grade(edge - 1e-9), complexity_grade(edge + 1e-9));
        }
        for edge in [0.5, 0.8] {
            near(efficiency_grade(edge - 1e-9), efficiency_grade(edge + 1e-9));
        }
        near(complexity_grade(1.4), 87.5);
        near(complexity_grade(1.75), 37.5);
        near(complexity_grade(2.2), 0.0);
        near(efficiency_grade(1.2), 100.0);
        near(efficiency_grade(0.65), 87.5);
        near(efficiency_grade(0.2), 30.0);
        assert!(averages(&[]).is_none());
    }
}
