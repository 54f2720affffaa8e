//! Labs 7 and 9.

use super::draw::Inputs;
use super::{Numbers, integers, three_digits};
use oracle::hard::first_touch;

pub(super) fn numbers(inputs: &mut Inputs) -> Vec<Numbers> {
    [collisions(), device(inputs)].concat()
}

fn collisions() -> Vec<Numbers> {
    let touch = |apart, closing| first_touch(apart, closing, 1.0).unwrap();
    assert_eq!(first_touch([3.0, 4.0], [-3.0, -1.0], 1.0), None, "discs of question 7.1 that pass");
    let root = three_digits(99.96_f64.sqrt());
    let (textbook, other) =
        ((10.0 - root) / 100.0, three_digits(0.0004 / three_digits(10.0 + root)));

    // The discs of each candidate collision, in order of time. A collision with a wall has one
    // disc.
    let candidates: [&[usize]; 6] = [&[1, 2], &[0, 1], &[4], &[2, 3], &[3, 4], &[0]];
    let (mut free, mut taken) = ([true; 5], 0);
    for discs in candidates {
        if discs.iter().all(|disc| free[*disc]) {
            discs.iter().for_each(|disc| free[*disc] = false);
            taken += 1;
        }
    }
    let left = free.iter().position(|free| *free).unwrap();
    assert_eq!(free.iter().filter(|free| **free).count(), 1);

    let pairs = |rows: std::ops::Range<usize>| rows.map(|row| 7 - row).sum::<usize>() as f64;
    let (first, second) = (pairs(0..4), pairs(4..8));

    // `done` computes the time at which the later of two workers finishes, if they take chunks of
    // rows from a queue.
    let done = |chunk: usize| {
        let mut busy = [0.0; 2];
        for start in (0..8).step_by(chunk) {
            let next = usize::from(busy[1] < busy[0]);
            busy[next] += pairs(start..start + chunk);
        }
        busy[0].max(busy[1])
    };

    let swept = |x: f64, v: f64, from: f64, to: f64| {
        let (a, b) = (x + v * from, x + v * to);
        [a.min(b) - 1.0, a.max(b) + 1.0]
    };
    let (a, bx, by) =
        (swept(3.0, 4.0, 0.0, 1.0), swept(9.0, 0.0, 0.0, 1.0), swept(10.0, -8.0, 0.0, 1.0));
    let (d, closing) = ([6.0, 7.0], [-4.0_f64, -8.0_f64]);
    let cross: f64 = d[0] * closing[1] - d[1] * closing[0];
    let delta = 4.0 * (closing[0].powi(2) + closing[1].powi(2)) - cross.powi(2);
    assert_eq!(first_touch(d, closing, 1.0), None, "discs of question 7.9 that pass");
    vec![
        ("7.1", vec![touch([5.0, 0.0], [-6.0, 0.0]), touch([3.0, 4.0], [-4.0, -4.0])]),
        ("7.2", vec![textbook, other]),
        ("7.3", integers([taken, left])),
        ("7.5", vec![first, second, (first + second) / (2.0 * first), 4.0 / 3.0]),
        ("7.8", vec![done(1), done(2), done(4)]),
        ("7.9", [&a[..], &bx, &by, &swept(3.0, 4.0, 0.0, 0.5)[1..], &[delta]].concat()),
    ]
}

fn device(inputs: &mut Inputs) -> Vec<Numbers> {
    let bins = inputs.one("9.4 bins", &[1_000_000.0, 2_000_000.0, 500_000.0]) as usize;
    let groups = |items: usize| items.div_ceil(64);
    let mut sums = vec![2, 1, 0, 3, 4, 0, 1, 1];
    let items = sums.clone();
    let mut memory = Vec::new();
    for reach in [1, 2, 4] {
        sums = (0..8).map(|i| sums[i] + if i >= reach { sums[i - reach] } else { 0 }).collect();
        memory.extend(&sums);
    }
    memory.extend(sums.iter().zip(&items).map(|(sum, own)| sum - own));
    memory.push(1024_usize.ilog2() as usize);
    let levels = std::iter::successors(Some(groups(bins)), |blocks| {
        Some(groups(*blocks)).filter(|_| *blocks > 1)
    });
    let gap = |x: f32| f64::from(x.next_up() - x);
    let arrival = |order: [usize; 3]| 10 + order.iter().position(|id| *id == 5).unwrap();
    let rank = 10 + [7, 2, 5].iter().filter(|id| **id < 5).count();
    let working = [1024, 32].map(|threads| 10_000_usize.div_ceil(threads));
    vec![
        (
            "9.1",
            integers([
                groups(100_000),
                groups(100_000) * 64 - 100_000,
                groups(10_000_000),
                groups(10_000_000).div_ceil(65_535),
            ]),
        ),
        ("9.2", integers(memory)),
        ("9.4", integers(levels)),
        ("9.5", vec![gap(7000.0), gap(0.3)]),
        ("9.7", integers([arrival([7, 2, 5]), arrival([5, 7, 2]), rank])),
        ("9.9", integers(working.into_iter().chain(working.map(|groups| groups.min(72))))),
    ]
}
