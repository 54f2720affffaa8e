//! Labs 10 to 12.

use std::f64::consts::{PI, SQRT_2};

use super::draw::Inputs;
use super::{Numbers, integers, starts, three_digits};

pub(super) fn numbers(inputs: &mut Inputs) -> Vec<Numbers> {
    [lists(inputs), windows(inputs), methods(inputs)].concat()
}

fn lists(inputs: &mut Inputs) -> Vec<Numbers> {
    let fastest = inputs.one("10.1 fastest", &[0.05, 0.03, 0.06]);
    let steps = |skin: f64, furthest: f64| (skin / 2.0 / furthest).round();
    let cost = |s: f64| 19.0 / (5.0 * s) + 2.0 / 3.0 * 0.1 * PI * (1.0 + s).powi(2);
    let near = [1, 0, 0, 1, 1, 0];
    let kept: usize = near.iter().sum();
    let (outer, inner) = (steps(1.6, 0.1), steps(0.4, 0.1));
    let (wide, narrow) = (2.6_f64.powi(2), 1.4_f64.powi(2));
    vec![
        ("10.1", vec![steps(0.6, fastest), steps(1.2, fastest), (2.2_f64 / 1.6).powi(2)]),
        ("10.2", vec![cost(1.0), cost(2.0), cost(3.0)]),
        ("10.4", integers([starts(&near), vec![kept]].concat())),
        ("10.6", vec![64.0 / 40.0, 6.2 / (64.0 / 40.0)]),
        ("10.7", vec![outer, inner, outer / inner, narrow + wide / inner, wide]),
    ]
}

fn windows(inputs: &mut Inputs) -> Vec<Numbers> {
    let grouped = inputs.one("11.8 grouped", &[30.0, 20.0, 50.0]) / 100.0;
    inputs.also("11.8 share", grouped);
    inputs.also("11.8 rest", 1.0 - grouped);
    let apart = |t: f64| (3.0 - t).hypot(2.0);
    let mut roots: Vec<usize> = (0..10).collect();
    for (a, b) in [(4, 7), (2, 9), (7, 9), (1, 5)] {
        let (kept, gone) = (roots[a].min(roots[b]), roots[a].max(roots[b]));
        roots.iter_mut().filter(|root| **root == gone).for_each(|root| *root = kept);
    }
    let groups =
        (0..10).filter(|root| roots.iter().filter(|other| **other == *root).count() > 1).count();
    let one_by_one = (0..8).fold(1.0, |x, _| three_digits(x + 0.004));
    let swept = 2.0 * 0.04 * SQRT_2 * 0.2;
    let updates = inputs.also("11.8 updates", grouped * 10.0 + 1.0 - grouped);
    vec![
        ("11.1", vec![3.0, apart(3.0), apart(2.0)]),
        ("11.2", integers([roots[7], roots[9], roots[5], groups])),
        ("11.4", vec![one_by_one, three_digits(1.0 + 8.0 * 0.004)]),
        ("11.5", vec![swept, (0.14_f64 / swept).floor(), (1.0 / swept).floor()]),
        ("11.8", vec![updates, 10.0 / updates]),
    ]
}

fn methods(inputs: &mut Inputs) -> Vec<Numbers> {
    let error = inputs.one("12.1 error", &[320.0, 480.0, 640.0]);
    let halved = |order: i32| error / 2.0_f64.powi(order);
    let half = -0.5;
    let (x, v) = (1.0 + half, half - 0.5 * (1.0 + half));
    let gap = f64::from(9000.0_f32.next_up() - 9000.0);
    vec![
        ("12.1", vec![halved(1), halved(2), halved(4)]),
        ("12.2", vec![38.0_f64.ln() / 10.0_f64.ln(), 800.0_f64.ln() / 5.0_f64.ln()]),
        ("12.3", vec![x, v, (x * x + v * v) / 2.0, 1.0, 2.0]),
        ("12.4", illinois()),
        ("12.6", vec![gap]),
    ]
}

/// Returns the times of the first three chords, and of the third without Illinois's halving. The
/// low end stays at 0.
fn illinois() -> Vec<f64> {
    let f = |t: f64| 1.0 / (t + 0.25) - 2.0;
    let chord = |low: f64, high: f64| high * low / (low - f(high));
    let first = chord(f(0.0), 1.0);
    let second = chord(f(0.0), first);
    vec![first, second, chord(f(0.0) / 2.0, second), chord(f(0.0), second)]
}
