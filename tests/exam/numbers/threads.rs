//! Labs 1 to 4.

use std::f64::consts::PI;

use super::draw::Inputs;
use super::{Numbers, integers, starts, three_digits};
use oracle::fold;

pub(super) fn numbers(inputs: &mut Inputs) -> Vec<Numbers> {
    [all_pairs(inputs), bins(inputs), buffers(inputs), locks(inputs)].concat()
}

fn all_pairs(inputs: &mut Inputs) -> Vec<Numbers> {
    let test = inputs.one("1.1 test", &[0.5, 0.4, 0.8, 2.0]);
    inputs.also("1.1 step", test / 10.0);
    let seconds = |n: f64| test * 1e-9 * n * n * 1000.0;
    let moved = |x: f64, v: f64, a: f64| fold(x + v + a, v + a, 10.0);
    let walls = [moved(9.7, 0.8, 0.4), moved(2.0, -25.0, 0.0)];
    let acceleration = |dx: f64, dy: f64| {
        let r = dx.hypot(dy);
        let factor = if r <= 1.0 { (1.0 - 1.0 / r) / (r * r) } else { 0.0 };
        [factor * dx, factor * dy]
    };
    let accelerations = [acceleration(0.5, 0.0), acceleration(0.3, 0.4), acceleration(1.2, 0.0)];
    let energy = |symplectic: bool| {
        let (mut x, mut v) = (1.0_f64, 0.0_f64);
        for _ in 0..2 {
            let old = v;
            v -= 0.5 * x;
            x += 0.5 * if symplectic { v } else { old };
        }
        (x * x + v * v) / 2.0
    };
    let add = |a: f64, b: f64| three_digits(a + b);
    vec![
        ("1.1", vec![seconds(1e4), seconds(2e4)]),
        ("1.2", walls.iter().flat_map(|(x, v)| [*x, *v]).collect()),
        (
            "1.3",
            vec![
                accelerations.iter().map(|a| a[0]).sum(),
                accelerations.iter().map(|a| a[1]).sum(),
            ],
        ),
        ("1.5", vec![add(add(1.0, 0.004), 0.004), add(1.0, add(0.004, 0.004))]),
        ("1.6", vec![16.0_f64.powi(2), 16.0]),
        ("1.7", vec![energy(true), energy(false)]),
    ]
}

fn bins(inputs: &mut Inputs) -> Vec<Numbers> {
    let density = inputs.one("2.3 density", &[0.2, 0.1, 0.3]);
    let bins = [2, 0, 2, 1, 3, 0, 2];
    let counts: Vec<usize> = (0..4).map(|bin| bins.iter().filter(|b| **b == bin).count()).collect();
    let mut order: Vec<usize> = (0..bins.len()).collect();
    order.sort_by_key(|particle| bins[*particle]);

    let (mut head, mut next) = ([-1.0; 2], [-1.0; 5]);
    for (particle, bin) in [1, 0, 1, 1, 0].into_iter().enumerate() {
        next[particle] = std::mem::replace(&mut head[bin], particle as f64);
    }
    let walk =
        std::iter::successors(Some(head[1]), |at| Some(next[*at as usize]).filter(|at| *at >= 0.0));
    let walk: Vec<f64> = walk.collect();

    let near = |a: usize, b: usize| (a / 4).abs_diff(b / 4) <= 1 && (a % 4).abs_diff(b % 4) <= 1;
    let visits = |twice: bool| {
        let pairs = (0..16).flat_map(|a| (0..16).map(move |b| (a, b)));
        pairs.filter(|(a, b)| near(*a, *b) && (twice || a <= b)).count()
    };
    vec![
        ("2.1", vec![10.3_f64.floor(), 10.3 / 10.3_f64.floor(), 10.3_f64.floor() - 1.0]),
        ("2.2", integers([counts.clone(), starts(&counts), order].concat())),
        ("2.3", [9.0, 9.0 * 1.5 * 1.5, 9.0 * 4.0, PI].map(|area| area * density).to_vec()),
        ("2.4", [&head[..], &next, &walk].concat()),
        ("2.6", integers([visits(true), visits(false)])),
        ("2.8", vec![6.25 * 0.2, 9.0 * 0.2, 6.25 * 20.0, 9.0 * 20.0]),
    ]
}

fn buffers(inputs: &mut Inputs) -> Vec<Numbers> {
    let serial_part = inputs.one("3.1 share", &[5.0, 4.0, 10.0, 20.0]) / 100.0;
    inputs.also("3.1 serial", serial_part);
    inputs.also("3.1 rest", 1.0 - serial_part);
    let amdahl = |p: f64| 1.0 / (serial_part + (1.0 - serial_part) / p);
    let one = inputs.one("3.2 one", &[80.0, 90.0, 70.0]);
    let best = inputs.one("3.2 best", &[60.0, 55.0, 50.0]);
    let weak = inputs.one("3.2 weak", &[100.0, 125.0, 160.0]);
    inputs.also("3.2 same", one);
    inputs.also("3.2 large", weak);
    let threads = inputs.one("3.9 threads", &[8.0, 4.0, 5.0]);
    inputs.also("3.9 again", threads);
    let [four, eight] = [("3.10 four", [3.2, 3.0, 2.5]), ("3.10 eight", [4.8, 4.2, 4.0])]
        .map(|(name, choices)| inputs.one(name, &choices));
    let serial = |speed_up: f64, p: f64| (1.0 / speed_up - 1.0 / p) / (1.0 - 1.0 / p);
    // Bit k of an order is the thread that acts at turn k. Each thread first reads, then writes.
    let orders: Vec<_> = (0..16_u32).filter(|turns| turns.count_ones() == 2).collect();
    let total = |turns: u32| {
        let (mut total, mut read) = (5, [None; 2]);
        for turn in 0..4 {
            let thread = (turns >> turn & 1) as usize;
            match read[thread] {
                None => read[thread] = Some(total),
                Some(old) => total = old + [1, 2][thread],
            }
        }
        total
    };
    let lost = orders.iter().filter(|turns| total(**turns) != 8).count();
    let slowest =
        |starts: [usize; 5]| starts.windows(2).map(|ends| ends[1] - ends[0]).max().unwrap() as f64;
    let (uneven, even) = (slowest([0, 2, 4, 6, 11]), slowest([0, 1, 2, 3, 4].map(|k| k * 11 / 4)));
    vec![
        ("3.1", vec![amdahl(2.0), amdahl(8.0), amdahl(f64::INFINITY)]),
        ("3.2", vec![one / 25.0, one / 100.0, best / 25.0, best / 100.0, one / weak]),
        ("3.3", integers([orders.len(), lost])),
        ("3.5", vec![uneven, 11.0 / uneven, even, 11.0 / even]),
        ("3.7", vec![64.0 / 8.0]),
        ("3.9", vec![1.0 / threads]),
        ("3.10", vec![serial(four, 4.0), serial(eight, 8.0)]),
    ]
}

fn locks(inputs: &mut Inputs) -> Vec<Numbers> {
    let step = inputs.one("4.3 step", &[400.0, 600.0, 300.0]);
    let busy = inputs.also("4.3 busy", step / 50.0);
    inputs.also("4.3 again", step);
    let first = inputs.one("4.8 first", &[58.0, 54.0, 64.0]);
    let best = inputs.one("4.8 best", &[20.0, 24.0, 27.0]);
    inputs.also("4.8 old", first);
    inputs.also("4.8 final", best);
    let speed_up = |p: f64| (10.0 + 400.0) / (10.0 + 400.0 / p);
    vec![
        ("4.1", integers([3 / 5, 7 / 5, 11 / 5])),
        ("4.2", integers([12_usize.div_ceil(5), 11 / 5, 11 % 5])),
        ("4.3", vec![busy, busy]),
        ("4.7", vec![speed_up(16.0), speed_up(f64::INFINITY)]),
        ("4.8", vec![first / 72.0, best / 72.0]),
    ]
}
