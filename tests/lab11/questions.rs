//! What tests and probe ask alike about windows, with drawn inputs and what a plain model says.

use common::soft::{CUTOFF, DT};
use lab11::{LONGEST, closest_squared, fly, join, meets_wall, root, too_far_off, window_length};
use windows::Span;

use super::ask::{Ask, beside, flags, rounded};
use crate::Random;

/// Few and many particles, slow and fast, for no step and for many: to the bit.
pub(super) fn flights(random: &mut Random, ask: Ask<'_>) {
    let sizes = random.sizes(4097);
    let mut steps = || [0, 1, 2, 7, 48, 65, 257, random.below(300) as u32];
    let few = sizes.into_iter().flat_map(|n| steps().map(|steps| (n, steps)));
    // More of either than 16 bits count.
    let all: Vec<_> = few.chain([(70_000, 3), (3, 70_000)]).collect();
    for (n, steps) in all {
        let dt = random.magnitude(1e-9, 1e3);
        let mut draw = || (0..n).map(|_| random.signed(1e-12, 1e12)).collect();
        let (start, v): (Vec<f64>, Vec<f64>) = (draw(), draw());
        let right = start.iter().zip(&v).map(|(x, v)| (0..steps).fold(*x, |x, _| x + v * dt));
        let right = right.collect();
        let mut found = start.clone();
        fly(&mut found, &v, steps, dt);
        let question = format!("where {n} particles are after {steps} steps of {dt:?}, bit by bit");
        ask(&question, found, right);
    }
}

/// Two that are near or far, and slow or fast for the time they have.
pub(super) fn approaches(random: &mut Random, ask: Ask<'_>) {
    for case in 0..4000 {
        let (unit, span) = (random.magnitude(1e-12, 1e12), random.magnitude(1e-9, 1e9));
        let mut vector = |size: f64| {
            [0, 1].map(|_| if random.below(6) == 0 { 0.0 } else { size * random.signed(1e-2, 1.0) })
        };
        let [dx, dy] = vector(unit);
        // At rest to each other, side by side, or not; they need some part of the time, or more.
        let [mut wx, mut wy] = vector(unit / span);
        let fast = random.magnitude(1e-3, 1e6);
        match case % 5 {
            0 => (wx, wy) = (0.0, -0.0),
            1 => (wx, wy) = (-dy / span * fast, dx / span * fast),
            2 => (wx, wy) = (-dx / span * fast, -dy / span * fast),
            _ => (wx, wy) = (wx * fast, wy * fast),
        }
        let span = if case % 11 == 0 { 0.0 } else { span };
        let moved = wx * wx + wy * wy;
        let along = if moved > 0.0 { -(dx * wx + dy * wy) / moved } else { 0.0 };
        let at = along.clamp(0.0, span);
        let (x, y) = (dx + at * wx, dy + at * wy);
        let right = x * x + y * y;
        // Rounding moves each point a little; the nearest distance does not change with the moment.
        let gone = (dx * dx + dy * dy + at * at * moved).sqrt();
        let scale = 1e-2 * gone * right.sqrt() + 1e-17 * gone * gone;
        let found = closest_squared(dx, dy, wx, wy, span);
        let question = format!(
            "the least squared distance of two that are ({dx:?}, {dy:?}) apart, the second with velocity ({wx:?}, \
             {wy:?}) as seen by the first, for {span:?}"
        );
        ask(&question, vec![rounded(found, right, scale)], vec![right]);
    }
}

/// How many parents a number has above it.
fn links(parent: &[u32], mut k: usize) -> usize {
    let mut links = 0;
    while parent[k] as usize != k && links <= parent.len() {
        (k, links) = (parent[k] as usize, links + 1);
    }
    links
}

/// Chains and trees: the root of a number, whether its path is shorter then, and whether no number left its group.
pub(super) fn roots(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(65_537).into_iter().chain([70_000]).filter(|&n| n > 0) {
        for case in 0..3 {
            // Two chains, or parents anywhere before their children; some begin a group.
            let mut parent: Vec<u32> = (0..n as u32).collect();
            for (k, parent) in parent.iter_mut().enumerate().skip(1) {
                let any = random.below(k) as u32;
                let alone = random.below(n.min(50)) == 0;
                let chain = if k == n - n / 14 { k } else { k - 1 };
                *parent = [chain as u32, if alone { k as u32 } else { any }, k as u32][case];
            }
            let mut labels = parent.clone();
            (0..n).for_each(|k| labels[k] = labels[labels[k] as usize]);
            for k in [n - 1, random.below(n)] {
                let before = links(&parent, k);
                let name = format!("{n} numbers, the path of {k}");
                let found = f64::from(root(&mut parent, k as u32));
                ask(&format!("{name}: the root"), vec![found], vec![f64::from(labels[k])]);
                let after = links(&parent, k);
                let question = format!("{name}: is it half as long then, or less?");
                ask(&question, flags(&[after <= before / 2 + 1]), flags(&[true]));
            }
            let mut now = parent.clone();
            let least = parent.iter().zip(0..).all(|(parent, k)| *parent <= k);
            ask(&format!("{n} numbers: is each parent less?"), flags(&[least]), flags(&[true]));
            (0..n).for_each(|k| now[k] = now[now[k] as usize]);
            let real = |all: Vec<u32>| all.into_iter().map(f64::from).collect();
            ask(&format!("{n} numbers: the root of each afterwards"), real(now), real(labels));
        }
    }
}

/// A chain of a million, from its end.
pub(super) fn long_chain(ask: Ask<'_>) {
    let mut parent: Vec<u32> = (0..1_000_000).map(|k: u32| k.saturating_sub(1)).collect();
    let found = root(&mut parent, 999_999);
    ask("the root of a chain of a million, from its end", vec![f64::from(found)], vec![0.0]);
}

/// A million, each joined to the next: who goes through all of them at each pair does not come to an end.
pub(super) fn many_joins(ask: Ask<'_>) {
    let mut parent: Vec<u32> = (0..1_000_000).collect();
    (1..1_000_000).for_each(|k| join(&mut parent, k - 1, k));
    let found = root(&mut parent, 999_999);
    ask(
        "a million, each joined to the next: the root of the last",
        vec![f64::from(found)],
        vec![0.0],
    );
}

/// Pairs in any order, also of one group or of one number: the root of each number.
pub(super) fn joins(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(4097).into_iter().chain([70_000]).filter(|&n| n > 0) {
        let mut parent: Vec<u32> = (0..n as u32).collect();
        let mut labels = parent.clone();
        for round in 0..20 {
            let any = [random.below(n), random.below(n)];
            let [a, b] = [any, [n - 1, any[0]], [any[0], n - 1]][round % 3];
            join(&mut parent, a as u32, b as u32);
            let (low, high) = (labels[a].min(labels[b]), labels[a].max(labels[b]));
            labels.iter_mut().filter(|label| **label == high).for_each(|label| *label = low);
            // By hand: to find a root is another function's question.
            let mut now = parent.clone();
            let grown = parent.iter().zip(0..).position(|(parent, k)| *parent > k);
            let question = format!(
                "{n} numbers, {a} and {b} joined: the first whose parent is greater, or -1"
            );
            ask(&question, vec![grown.map_or(-1.0, |k| k as f64)], vec![-1.0]);
            (0..n).for_each(|k| now[k] = now[now[k] as usize]);
            let real = |all: &[u32]| all.iter().map(|k| f64::from(*k)).collect();
            ask(&format!("{n} numbers, {a} and {b} joined: each root"), real(&now), real(&labels));
        }
    }
}

/// Off by half the margin exactly, by a hair more or less, and by anything.
pub(super) fn margins(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..1000 {
        let margin = random.magnitude(1e-15, 1e12);
        let [half, less, more] = beside(margin / 2.0);
        let some = margin * random.magnitude(1e-6, 1e6);
        for (off, right) in
            [(half, false), (less, false), (more, true), (0.0, false), (some, some > margin / 2.0)]
        {
            let question = format!(
                "whether one that is {off:?} off its path may have met another, margin {margin:?}"
            );
            ask(&question, flags(&[too_far_off(off, margin)]), flags(&[right]));
        }
    }
}

/// Windows of any length that end far from walls, beside them, or exactly as near as rounding goes.
pub(super) fn walls(random: &mut Random, ask: Ask<'_>) {
    for case in 0..6000 {
        let steps = 1 + random.below(64) as u32;
        let dt = [DT, random.magnitude(1e-9, 1.0)][case % 2];
        let span = Span { steps, dt, size: random.magnitude(1e-2, 1e6) };
        let (size, flown, near) = (span.size, f64::from(steps) * dt, span.rounding());
        let along = |random: &mut Random| {
            let to = random.below(2) as f64 * size + near * random.signed(0.01, 100.0);
            let x = random.between(0.0, size);
            let edges = [beside(near), beside(size - near)].concat();
            let v = random.signed(1e-9, 10.0) * size / flown;
            match random.below(7) {
                // At rest, to the bit; and to a position near a wall, from near and far; and away from a wall.
                0 => (edges[random.below(6)], 0.0),
                1 => (x, (to - x) / flown),
                2 => (
                    to - 1e-3 * size * (to - 0.5 * size).signum(),
                    (to - 0.5 * size).signum() * 1e-3 * size / flown,
                ),
                3 => [(f64::NAN, 0.0), (x, f64::NAN)][random.below(2)],
                4 => (x, v),
                5 => ([0.0, size, near, size - near][random.below(4)], v),
                _ => (x, 0.0),
            }
        };
        let ((x, vx), (y, vy)) = (along(random), along(random));
        // Whether it stays, and where rounding may decide.
        let stays = |x: f64, v: f64| {
            let end = x + v * flown;
            let open =
                v != 0.0 && [near, size - near].iter().any(|at| (end - at).abs() < 1e-13 * size);
            (end >= near && end <= size - near, open)
        };
        let (across, up) = (stays(x, vx), stays(y, vy));
        if !across.1 && !up.1 {
            let question = format!(
                "whether a particle at ({x:?}, {y:?}) with velocity ({vx:?}, {vy:?}) may meet a wall of a box of \
                 {size:?} in {steps} steps of {dt:?}; within {near:?} of one counts"
            );
            let meets = meets_wall(&span, x, y, vx, vy);
            ask(&question, flags(&[meets]), flags(&[!(across.0 && up.0)]));
        }
    }
}

/// Thin and dense, slow and fast: from windows of one step to the longest.
pub(super) fn lengths(random: &mut Random, ask: Ask<'_>) {
    for case in 0..3000 {
        let density = random.magnitude(1e-6, 1e12);
        // A speed for which a window has this number of steps.
        let whole = 1.0 + random.below(49) as f64;
        let steps = [random.magnitude(1e-3, 1e3), random.between(1.0, 50.0), whole][case % 3];
        let speed = 0.14 / (steps * 2.0 * CUTOFF * 2_f64.sqrt() * DT * density);
        let (speed, density) = if case % 20 == 0 {
            [(0.0, density), (speed, 0.0)][case % 40 / 20]
        } else {
            (speed, density)
        };
        let most = 0.14 / (2.0 * CUTOFF * 2_f64.sqrt() * speed * DT * density);
        let length = |steps: f64| steps.floor().clamp(1.0, f64::from(LONGEST));
        let found = f64::from(window_length(density, speed));
        // Rounding may decide between two.
        let right = [length(most * (1.0 - 1e-12)), length(most * (1.0 + 1e-12))];
        let right = if right.contains(&found) { found } else { right[0] };
        let question =
            format!("the window for {density:?} particles per area and a mean speed of {speed:?}");
        ask(&question, vec![found], vec![right]);
    }
}
