//! What tests and probe ask alike about collisions, with drawn inputs and what a plain model says.
//!
//! Whole numbers times a power of two make products without rounding: there a tie is a tie.

use common::Vec2;
use common::hard::{Disc, RandomScene, Simulation};
use hard_discs::{
    Candidate, Choice, Engine, Find, Found, Hit, LockedCount, SharedCount, Slots, Square, Window,
    Workers,
};
use lab7::{
    Lab7, VARIANTS, append_atomic, append_locked, bounce, collide, collide_in, order, pair_time,
    stop_at_wall, take, take_in_order, wall_hit,
};

use super::ask::{Ask, beside, flags, memory, rounded, truth};
use super::model::{What, first_touch, possible};
use crate::Random;

/// Numbers of discs where eight, sixteen bits and a sign end.
const NUMBERS: [u32; 10] =
    [0, 1, 255, 256, 65_535, 65_536, 0x7fff_ffff, 0x8000_0000, 0xffff_fffd, 0xffff_fffe];

fn number(random: &mut Random) -> u32 {
    [NUMBERS[random.below(NUMBERS.len())], random.bits() as u32 >> 1][random.below(2)]
}

/// A unit of length, from small to large; a power of two in every other case.
fn unit(random: &mut Random, case: usize) -> f64 {
    let unit = random.magnitude(1e-12, 1e12);
    if case.is_multiple_of(2) { unit.log2().round().exp2() } else { unit }
}

fn words(disc: &Disc) -> String {
    format!("({:?}, {:?}) with velocity ({:?}, {:?})", disc.x, disc.y, disc.vx, disc.vy)
}

/// A number as it was drawn; a power of ten near it in `plain` scenes, which are asked first.
pub(super) fn short(plain: bool, number: f64) -> f64 {
    let power = 10_f64.powf(number.abs().log10().round()).copysign(number);
    if plain { power } else { number }
}

/// What happens, and when.
fn event(candidate: &Candidate) -> String {
    let what = match candidate.hit {
        Hit::Corner(a) => format!("disc {a} hits a corner"),
        Hit::WallX(a) => format!("disc {a} hits the left or right wall"),
        Hit::WallY(a) => format!("disc {a} hits the lower or upper wall"),
        Hit::Pair(a, b) => format!("discs {a} and {b} touch"),
    };
    format!("{what} at λ = {:?}", candidate.time)
}

/// How [`values`] tell candidates.
const EACH: &str = "λ, what (0 a corner, 1 the left or right wall, 2 the lower or upper one, 3 a pair), and the discs \
                    (-1 for none) of each";

/// Candidates as numbers. Either zero will do.
fn values(candidates: &[Candidate]) -> Vec<f64> {
    let value = |c: &Candidate| {
        let kind = match c.hit {
            Hit::Corner(_) => 0.0,
            Hit::WallX(_) => 1.0,
            Hit::WallY(_) => 2.0,
            Hit::Pair(..) => 3.0,
        };
        let second = c.hit.second().map_or(-1.0, f64::from);
        [c.time + 0.0, kind, f64::from(c.hit.first()), second]
    };
    candidates.iter().flat_map(value).collect()
}

/// Walls far and near, at rest, just reached or not, from outside by a hair, and corners.
pub(super) fn walls(random: &mut Random, ask: Ask<'_>) {
    for case in 0..2400 {
        let plain = case < 100;
        let unit = if plain { 1.0 } else { unit(random, case) };
        let whole = |random: &mut Random, most: usize| random.below(most + 1) as f64;
        let (room, radius) = (2.0 + whole(random, 20), unit);
        let square = Square { side: (room + 2.0) * unit, radius };
        let along = |random: &mut Random| {
            let x = (1.0 + whole(random, room as usize)) * unit;
            let fast = random.signed(1e-9, 1e6) * unit;
            let to = [0.0, 1.0, room + 1.0, room + 2.0][random.below(4)] * unit - x;
            let hair = [square.least().next_down(), square.most().next_up()];
            let slow = random.signed(1e-3, 1e3) * f64::EPSILON * unit;
            match random.below(6) {
                _ if plain => (x, [-8.0, -4.0, 0.0, 4.0, 8.0, 16.0][random.below(6)]),
                0 => (x, fast),
                1 => (x, beside(to)[random.below(3)]),
                2 => (x, random.between(-1.5, 1.5) * room * unit),
                3 => (hair[random.below(2)], [slow, fast][random.below(2)]),
                _ => (x, [-8.0, -4.0, 0.0, 4.0, 8.0, 16.0][random.below(6)] * unit),
            }
        };
        let ((x, vx), (y, vy)) = (along(random), along(random));
        let a = if plain { case as u32 } else { number(random) };
        let disc = Disc::new(x, y, vx, vy);
        let found = wall_hit(a, &disc, square);
        let events = possible(&[disc], square.side, radius);
        let right = events.first().map(|event| {
            let hit = match event.what {
                What::Corner => Hit::Corner(a),
                What::WallX => Hit::WallX(a),
                _ => Hit::WallY(a),
            };
            Candidate { time: event.time, hit }
        });
        let near = |c: Candidate| {
            let right = right.map_or(0.0, |right| right.time);
            Candidate { time: rounded(c.time, right, right), ..c }
        };
        let question = format!(
            "disc {a} of radius {radius:?} at {}, in a square of side {:?}: no number where it hits nothing; else {EACH}",
            words(&disc),
            square.side
        );
        ask(&question, values(found.map(near).as_slice()), values(right.as_slice()));
    }
}

/// Turned by quarters and mirrored.
fn turned(d: Vec2, how: usize) -> Vec2 {
    let d = if how & 1 == 0 { d } else { Vec2::new(d.y, d.x) };
    Vec2::new(if how & 2 == 0 { d.x } else { -d.x }, if how & 4 == 0 { d.y } else { -d.y })
}

/// Two discs of this radius, b as seen from a: when they touch, in this number of digits.
fn touches(ask: Ask<'_>, what: &str, a: Disc, (d, v): (Vec2, Vec2), radius: f64, digits: f64) {
    let b = Disc::new(a.x + d.x, a.y + d.y, a.vx + v.x, a.vy + v.y);
    let found = pair_time(&a, &b, radius);
    let (apart, closing) = (b.position() - a.position(), b.velocity() - a.velocity());
    let right = first_touch([apart.x, apart.y], [closing.x, closing.y], radius);
    let near = |found: f64, right: f64| rounded(found, right, right * 1e12 * digits);
    let found = found.map(|found| right.map_or(found, |right| near(found, right)) + 0.0);
    let question = format!(
        "{what}: discs of radius {radius:?} at {} and {}: when they touch (λ), nothing if they do not",
        words(&a),
        words(&b)
    );
    ask(&question, found.into_iter().collect(), right.into_iter().collect());
}

/// Discs anywhere that meet or not, where no rounding decides.
pub(super) fn meetings(random: &mut Random, ask: Ask<'_>) {
    let mut asked = 0;
    while asked < 3000 {
        let radius = random.magnitude(1e-12, 1e12);
        let speed = random.magnitude(1e-3, 1e3) * radius;
        let wide = radius * random.magnitude(1.0, 1e3);
        let mut vector =
            |size: f64| Vec2::new(random.between(-size, size), random.between(-size, size));
        let (d, v, at) = (vector(wide), vector(speed), vector(wide));
        // Half of them fly at each other.
        let v = if asked % 2 == 0 { v } else { (-1.5 * speed / wide) * d + 0.3 * v };
        let (s, cross, apart) = (d.dot(v), d.cross(v), d.norm_squared());
        let (reach, moved) = (4.0 * radius * radius, v.norm_squared());
        let delta = reach * moved - cross * cross;
        let scale = reach * moved + cross * cross;
        let time = (apart - reach) / (delta.max(0.0).sqrt() - s);
        let decided = |number: f64, scale: f64| number.abs() > 1e-4 * scale;
        if decided(delta, scale)
            && decided(s, (apart * moved).sqrt())
            && decided(apart - reach, apart + reach)
            && decided(time - 1.0, 1.0)
        {
            asked += 1;
            touches(ask, "anywhere", Disc::new(at.x, at.y, 0.0, 0.0), (d, v), radius, 1e-9);
        }
    }
    for times in [1e3, 1e6, 1e9, 1e12] {
        let d = Vec2::new(times, 0.0);
        touches(ask, "head on from far", Disc::new(0.0, 0.0, 0.0, 0.0), (d, -2.0 * d), 1.0, 1e-9);
    }
}

/// In contact, nearly so, side by side, grazing, at one position, and at the very end of the step.
pub(super) fn contacts(random: &mut Random, ask: Ask<'_>) {
    let rest = Disc::default();
    for case in 0..400 {
        let unit = unit(random, 0);
        let whole = |random: &mut Random, most: usize| (1 + random.below(most)) as f64;
        // A triangle of whole numbers: (p u)² + (q u)² = (r u)².
        let [p, q, r] =
            [[3.0, 4.0, 5.0], [12.0, 5.0, 13.0], [8.0, 15.0, 17.0]][case % 3].map(|s| s * unit);
        let (radius, how) = (r / 2.0, random.below(8));
        let far = whole(random, 40) * unit;
        let at = |x: f64, y: f64| turned(Vec2::new(x, y), how);
        let somewhere = Vec2::new(whole(random, 99) * unit, whole(random, 99) * unit);
        let moving = Disc::new(somewhere.x, somewhere.y, 7.0 * unit, -3.0 * unit);
        // To touch at (p, q) at the end of the step.
        let end = (at(p + far, q), at(-far, 0.0));
        touches(ask, "just at the end of the step", moving, end, radius, 1e-12);
        for by in [1.0 + 1e-12, 1.0 - 1e-12] {
            touches(ask, "at the end, nearly", rest, (end.0, by * end.1), radius, 1e-10);
        }
        for x in beside(r) {
            // Side by side, from the left: only Δ > 0 touches.
            let v = 4.0 * (r + far).log2().ceil().exp2();
            touches(ask, "grazing, or nearly", rest, (at(far, x), at(-v, 0.0)), radius, 1e-6);
            let v = random.signed(1e-9, 1e9) * r;
            touches(ask, "in contact, or nearly", rest, (at(x, 0.0), at(v, 0.0)), radius, 1e-12);
        }
        let (d, side) = (at(p, q), at(-q, p));
        touches(ask, "in contact, side by side", moving, (d, side), radius, 1e-12);
        // So nearly side by side that Δ is rounding: in contact counts, whatever the root says.
        let many = (1 << (8 + random.below(20))) as f64 + 1.0;
        let by = many * side - (unit / p) * at(p, 0.0);
        touches(ask, "in contact, nearly side by side", rest, (d, by), radius, 1e-12);
        let deep = random.magnitude(1e-12, 0.999);
        touches(ask, "overlapping", rest, (deep * d, -1.0 * d), radius, 1e-12);
        touches(ask, "overlapping and leaving", rest, (deep * d, d), radius, 1e-12);
        touches(ask, "overlapping, side by side", rest, (at(p, 0.0), at(0.0, q)), radius, 1e-12);
        touches(ask, "overlapping, at rest", rest, (deep * d, Vec2::ZERO), radius, 1e-12);
        touches(ask, "at one position", moving, (Vec2::ZERO, d), radius, 1e-12);
        touches(ask, "at rest", moving, (4.0 * d, Vec2::ZERO), radius, 1e-12);
        let gap = r * 0.5_f64.powi(1 + random.below(40) as i32);
        let speed = gap * random.magnitude(1.001, 1e6);
        let near = (at(r + gap, 0.0), at(-speed, 0.0));
        touches(ask, "nearly in contact", rest, near, radius, 1e-12);
    }
}

/// Any two of some candidates: at few times, of all kinds, with numbers at which bits end.
pub(super) fn orders(random: &mut Random, ask: Ask<'_>) {
    for _ in 0..40 {
        let time = random.magnitude(1e-300, 1.0);
        let times = [0.0, -0.0, time, time.next_up(), time.next_down(), 1.0];
        let mut draw = || {
            let (a, b) = (number(random), number(random));
            let pair = Hit::Pair(a.min(b), a.max(b));
            let hit = [Hit::Corner(a), Hit::WallX(a), Hit::WallY(a), pair, pair][random.below(5)];
            Candidate { time: times[random.below(6)], hit }
        };
        let all: Vec<Candidate> = (0..24).map(|_| draw()).collect();
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            let right = if a.time < b.time || a.time == b.time && a.hit < b.hit {
                -1.0
            } else {
                truth(a.time != b.time || a.hit != b.hit)
            };
            let question = format!(
                "the first, {}, comes before (-1), after (1) or is (0) the second, {}",
                event(a),
                event(b)
            );
            ask(&question, vec![f64::from(order(a, b) as i8)], vec![right]);
        }
    }
}

/// One candidate after the other, of all kinds, some discs not free any more.
pub(super) fn single_takes(random: &mut Random, ask: Ask<'_>) {
    for round in 0..300 {
        let discs = 2 + random.size(40.min(round));
        let free: Vec<bool> = (0..discs).map(|_| random.below(8) > 0).collect();
        let (mut left, mut taken) =
            (free.clone(), vec![Candidate { time: 0.5, hit: Hit::Corner(9) }]);
        let (mut right_left, mut right) = (free, taken.clone());
        for _ in 0..2 * discs {
            let (a, b) = (random.below(discs) as u32, random.below(discs) as u32);
            let pair = if a == b { Hit::WallY(a) } else { Hit::Pair(a.min(b), a.max(b)) };
            let hit = [pair, pair, Hit::Corner(a), Hit::WallX(a)][random.below(4)];
            let candidate = Candidate { time: random.between(0.0, 1.0), hit };
            let gone: Vec<usize> = (0..discs).filter(|&disc| !left[disc]).collect();
            let question =
                format!("{}, and these are not free any more: {gone:?}", event(&candidate));
            take(&candidate, &mut left, &mut taken);
            naive_take(&candidate, &mut right_left, &mut right);
            ask(&format!("{question}: {EACH} that was taken"), values(&taken), values(&right));
            ask(&format!("{question}: is each free then?"), flags(&left), flags(&right_left));
        }
    }
}

fn naive_take(candidate: &Candidate, free: &mut [bool], taken: &mut Vec<Candidate>) {
    let discs = [Some(candidate.hit.first()), candidate.hit.second()].into_iter().flatten();
    if discs.clone().all(|disc| free[disc as usize]) {
        discs.for_each(|disc| free[disc as usize] = false);
        taken.push(*candidate);
    }
}

/// Few and many candidates in any order, beside some that an earlier window took. The earlier one of two has the
/// lower number and walls have the lowest: which of these counts is another task.
pub(super) fn takes(random: &mut Random, ask: Ask<'_>) {
    let sizes = [random.sizes(4097), vec![70_000]].concat();
    for n in sizes.into_iter().flat_map(|n| [n, n]) {
        let discs = [n + 2, 20 * n + 2][random.below(2)];
        let free: Vec<bool> = (0..discs + 3).map(|_| random.below(9) > 0).collect();
        let mut hits: Vec<Hit> = (0..n)
            .map(|_| {
                let (a, b) = (random.below(discs) as u32, random.below(discs) as u32);
                if a == b || a < discs as u32 / 9 {
                    Hit::WallX(a)
                } else {
                    Hit::Pair(a.min(b), a.max(b))
                }
            })
            .collect();
        hits.sort_unstable();
        hits.dedup();
        let gap = 0.9 / (hits.len() + 1) as f64;
        let mut candidates = Vec::new();
        let mut time = 0.0;
        for (k, hit) in hits.into_iter().enumerate() {
            // Some have the time of the one before.
            if random.below(4) > 0 {
                time = (k as f64 + random.between(0.1, 0.9)) * gap;
            }
            candidates.push(Candidate { time, hit });
        }
        let before = Candidate { time: 0.99, hit: Hit::WallY(1) };
        let (mut right, mut right_free) = (vec![before], free.clone());
        candidates.iter().for_each(|c| naive_take(c, &mut right_free, &mut right));
        random.shuffle(&mut candidates);
        let (mut taken, mut left) = (vec![before], free);
        let name = format!("{} candidates among {discs} discs", candidates.len());
        take_in_order(&mut candidates, &mut left, &mut taken);
        ask(&format!("{name}: {EACH} that was taken, in order"), values(&taken), values(&right));
        ask(&format!("{name}: is each disc free then?"), flags(&left), flags(&right_free));
    }
    for discs in 1..=3 {
        let (mut taken, mut free) = (Vec::new(), vec![true; discs]);
        let hits = |a| Candidate { time: f64::from(a) / 4.0, hit: Hit::WallX(a) };
        let mut walls: Vec<_> = (0..discs as u32).rev().map(hits).collect();
        take_in_order(&mut walls, &mut free, &mut taken);
        walls.sort_by_key(|wall| wall.hit);
        let question = format!("each of {discs} free discs hits a wall: {EACH} that was taken");
        ask(&question, values(&taken), values(&walls));
    }
}

/// A million candidates, none of which stands in another's way: who compares every two does not come to an end.
pub(super) fn many_takes(random: &mut Random, ask: Ask<'_>) {
    let candidate = |a| Candidate { time: random.between(0.0, 1.0), hit: Hit::WallX(a) };
    let mut candidates: Vec<Candidate> = (0..1_000_000).map(candidate).collect();
    let (mut taken, mut free) = (Vec::new(), vec![true; candidates.len()]);
    take_in_order(&mut candidates, &mut free, &mut taken);
    let question =
        "of a million candidates of as many discs: those that were taken, and whether in order (1)";
    let sorted = taken.is_sorted_by_key(|candidate| candidate.time);
    ask(question, vec![taken.len() as f64, truth(sorted)], vec![1e6, 1.0]);
}

/// Beyond walls by some part of a step, by two steps or a little more or less, and by rounding.
pub(super) fn stops(random: &mut Random, ask: Ask<'_>) {
    for case in 0..2000 {
        let unit = unit(random, 0);
        let square = Square { side: (3 + random.below(30)) as f64 * unit, radius: unit };
        let (least, most) = (square.least(), square.most());
        let along = |random: &mut Random| {
            let v = log2_rounded(random.signed(0.25, 1e3)) * unit;
            let wall = if v > 0.0 { most } else { least };
            let hair = [most.next_up(), least.next_down()][random.below(2)];
            match random.below(5) {
                0 => (random.between(least, most), v),
                1 => (wall + beside(2.0 * v)[random.below(3)], v),
                2 => (hair, [0.0, -0.0, v * 1e-30][random.below(3)]),
                3 => (wall + random.between(0.0, 4.0) * v, v),
                _ => (wall + random.between(0.0, 1.0) * v, v),
            }
        };
        let ((x, vx), (y, vy)) = (along(random), along(random));
        let disc = Disc::new(x, y, vx, vy);
        let back = |x: f64, v: f64| {
            let time = (x - x.clamp(least, most)) / v;
            if x.clamp(least, most) != x && time > 0.0 && time <= 2.0 { time } else { 0.0 }
        };
        let time = back(x, vx).max(back(y, vy));
        let mut stopped = disc;
        stop_at_wall(&mut stopped, square);
        // What stays where it is stays there to the last digit.
        let near = |found: f64, x: f64, v: f64| {
            rounded(found, x - time * v, (time * v).abs().min(1e3 * square.side))
        };
        let question = format!(
            "case {case}: where a disc at {} waits, centres from {least:?} to {most:?}: x y vx vy",
            words(&disc)
        );
        let found = [near(stopped.x, x, vx), near(stopped.y, y, vy), stopped.vx, stopped.vy];
        ask(&question, found.to_vec(), vec![x - time * vx, y - time * vy, vx, vy]);
    }
}

/// The nearest power of two, of the same sign.
fn log2_rounded(number: f64) -> f64 {
    number.abs().log2().round().exp2().copysign(number)
}

fn with_counts(mut disc: Disc, random: &mut Random) -> Disc {
    let mut count = || [0, 254, 255, 65_534, 65_535, 1 << 24][random.below(6)];
    (disc.pair_collisions, disc.wall_collisions) = (count(), count());
    disc
}

/// x y vx vy of a disc, in a unit and near what is right, and its collisions with discs and with walls.
fn state(disc: &Disc, right: &Disc, scale: f64) -> Vec<f64> {
    let moving = |disc: &Disc| [disc.x, disc.y, disc.vx, disc.vy];
    let near = moving(disc).into_iter().zip(moving(right)).map(|(f, r)| rounded(f, r, scale));
    near.chain([disc.pair_collisions, disc.wall_collisions].map(f64::from)).collect()
}

/// Walls far away, and one straight ahead on the way back.
pub(super) fn bounces(random: &mut Random, ask: Ask<'_>) {
    for case in 0..1200 {
        let plain = case < 60;
        let unit = if plain { 1.0 } else { random.magnitude(1e-12, 1e12) };
        let hit = [Hit::WallX(0), Hit::WallY(0), Hit::Corner(0)][case % 3];
        let drawn = if plain { 0.5 } else { random.between(0.0, 1.0) };
        let time = [drawn, 0.0, 1.0][random.below(3)];
        let mut speed = || short(plain, random.signed(1e-6, 1e3)) * unit;
        let (vx, vy) = (speed(), speed());
        let mut before = Disc::new(5e3 * unit, 5e3 * unit, vx, vy);
        let mut right = before;
        (right.vx, right.vy) = [(-vx, vy), (vx, -vy), (-vx, -vy)][case % 3];
        right.x += time * vx + (1.0 - time) * right.vx;
        right.y += time * vy + (1.0 - time) * right.vy;
        // Straight at a wall it does not matter how it is brought back.
        if case % 6 < 2 {
            let v = vx.abs();
            let start = unit + 0.5 * (1.0 - time) * v - time * v;
            before =
                [Disc::new(start, right.y, v, 0.0), Disc::new(right.x, start, 0.0, v)][case % 3];
            let y = right.y;
            right = [Disc::new(unit, y, -v, 0.0), Disc::new(right.x, unit, 0.0, -v)][case % 3];
        }
        let mut disc = if plain { before } else { with_counts(before, random) };
        right.pair_collisions = disc.pair_collisions;
        right.wall_collisions = disc.wall_collisions + 1;
        let question = format!(
            "{}: of radius {unit:?}, at {}, in a square of side {:?}: x y vx vy, its collisions with discs and with walls",
            event(&Candidate { time, hit }),
            words(&disc),
            1e4 * unit
        );
        bounce(&mut disc, time, hit, Square { side: 1e4 * unit, radius: unit });
        ask(&question, state(&disc, &right, 1e4 * unit), state(&right, &right, 1.0));
    }
}

/// Two that touch, overlap or stand at one position, far from walls; and one that flies straight at a wall.
pub(super) fn collisions(random: &mut Random, ask: Ask<'_>) {
    for case in 0..1200 {
        let plain = case < 60;
        let unit = if plain { 1.0 } else { random.magnitude(1e-12, 1e12) };
        let drawn = if plain { 0.5 } else { random.between(0.0, 1.0) };
        let (side, time) = (1e6 * unit, [drawn, 0.0][random.below(2)]);
        let mut along = |size: f64| short(plain, random.signed(1e-3, size));
        let mut vector = |size: f64| Vec2::new(along(size), along(size));
        let (v, w, apart) = (unit * vector(1e3), unit * vector(1e3), vector(1.0));
        let apart = unit * [random.magnitude(1e-6, 1.0), 1.0, 0.0][random.below(3)] * apart;
        let apart = if plain { turned(Vec2::new(2.0, 0.0), case) } else { apart };
        // They touch somewhere: from there both go back.
        let position = Vec2::new(0.5 * side, 0.5 * side);
        let disc = |at: Vec2, v: Vec2| Disc::new(at.x - time * v.x, at.y - time * v.y, v.x, v.y);
        let (mut a, mut b) = (disc(position, v), disc(position + apart, w));
        let n = Vec2::new(
            (b.x + time * b.vx) - (a.x + time * a.vx),
            (b.y + time * b.vy) - (a.y + time * a.vy),
        );
        let along = (b.vx - a.vx) * n.x + (b.vy - a.vy) * n.y;
        let length = n.x * n.x + n.y * n.y;
        let gain = if length > 0.0 { (along / length) * n } else { Vec2::ZERO };
        if !plain {
            (a, b) = (with_counts(a, random), with_counts(b, random));
        }
        let question = format!(
            "case {case}, {} and {} of radius {unit:?} touch at λ = {time:?}, in a square of side {side:?}: x y vx vy, \
             collisions with discs and with walls of each",
            words(&a),
            words(&b)
        );
        let after = |disc: Disc, gain: Vec2| {
            let (vx, vy) = (disc.vx + gain.x, disc.vy + gain.y);
            let x = disc.x + time * disc.vx + (1.0 - time) * vx;
            let y = disc.y + time * disc.vy + (1.0 - time) * vy;
            let pair_collisions = disc.pair_collisions + 1;
            Disc { x, y, vx, vy, pair_collisions, ..disc }
        };
        let right = [after(a, gain), after(b, -1.0 * gain)];
        collide(&mut a, &mut b, time, Square { side, radius: unit });
        let moving = |disc: &Disc, right: &Disc| {
            // What comes of a direction is as exact as the direction: they may be very near.
            let exact = 1e-4 * side / length.sqrt().max(1e-9 * side);
            let scale = (v.norm_squared() + w.norm_squared()).sqrt() * exact.max(10.0);
            let mut found = state(disc, right, scale);
            (found[0], found[1]) =
                (rounded(disc.x, right.x, side + scale), rounded(disc.y, right.y, side + scale));
            found
        };
        let found = [moving(&a, &right[0]), moving(&b, &right[1])].concat();
        ask(&question, found, right.iter().flat_map(|right| state(right, right, 1.0)).collect());
    }
    // The second stands beside the wall at 0 and is pushed at it.
    for _ in 0..100 {
        let (unit, time) = (random.magnitude(1e-12, 1e12), random.between(0.0, 0.99));
        let speed = unit * random.magnitude(10.0, 1e3);
        let square = Square { side: 1e4 * unit, radius: unit };
        let (mut a, mut b) = (
            Disc::new(4.0 * unit + time * speed, 50.0 * unit, -speed, 0.0),
            Disc::new(2.0 * unit, 50.0 * unit, 0.0, 0.0),
        );
        let question = format!(
            "{} pushes {} of radius {unit:?} against the wall behind it at λ = {time:?}: x y vx vy of the second",
            words(&a),
            words(&b)
        );
        collide(&mut a, &mut b, time, square);
        let waits = 2.0 * unit - (1.0 - time) * speed < unit;
        let x = if waits { unit } else { 2.0 * unit - (1.0 - time) * speed };
        let right = Disc { pair_collisions: 1, ..Disc::new(x, 50.0 * unit, -speed, 0.0) };
        ask(&question, state(&b, &right, 1e3 * speed), state(&right, &right, 1.0));
    }
}

/// Finds one pair, whatever the window, and replaces the lists, as finders with several workers do.
struct One;

impl Find for One {
    fn find(&mut self, _: &[Disc], _: &[bool], _: Square, window: Window, found: &mut Found) {
        let time = window.from;
        found.lists = vec![vec![Candidate { time, hit: Hit::Pair(0, 1) }]];
    }
}

/// Finds no pair, and wants the step cut into this number of windows.
struct Nothing(usize);

impl Find for Nothing {
    fn windows(&mut self, _: &[Disc], _: Square) -> usize {
        self.0
    }

    fn find(&mut self, _: &[Disc], _: &[bool], _: Square, _: Window, _: &mut Found) {}
}

/// Discs that only walls stop: a step ends the same, into however many windows it is cut, and takes window by window.
pub(super) fn cut_steps(random: &mut Random, ask: Ask<'_>) {
    for windows in [2, 3, 8, 64] {
        let n = 1 + random.size(257);
        let disc = |_| {
            let [x, y] = [(); 2].map(|()| random.between(1.0, 9.0));
            let [vx, vy] = [(); 2].map(|()| random.between(-9.0, 9.0));
            Disc::new(x, y, vx, vy)
        };
        let scene = common::hard::Scene::new(10.0, 1.0, (0..n).map(disc).collect());
        let scene = scene.expect("all are inside");
        let [found, right] = [windows, 1].map(|windows| {
            let mut engine = Engine::<Lab7, _>::new(Nothing(windows), Choice::Sort, Workers::One);
            engine.load(&scene);
            engine.step();
            let ends = engine.discs.iter().flat_map(|disc| [disc.x, disc.y]).collect();
            (ends, engine.taken.iter().map(|hit| hit.time).collect::<Vec<_>>())
        });
        let question = format!(
            "{n} discs that only walls stop, in {windows} windows: x and y after a step, which are those of one window"
        );
        ask(&question, found.0, right.0);
        let question = format!(
            "{n} discs that only walls stop, in {windows} windows: times, as they are taken"
        );
        ask(&question, found.1, right.1);
    }
}

/// What is taken in a window of many: walls at its beginning, its end, their neighbours, and the end of the step.
pub(super) fn windows(random: &mut Random, ask: Ask<'_>) {
    for case in 0..300 {
        let count = [1, 2, 3, 8, 64][case % 5];
        let n = 2 + random.size(257);
        let mut times: Vec<f64> = (0..n)
            .map(|_| {
                beside(random.below(count + 1) as f64 / count as f64)[random.below(3)]
                    .clamp(0.0, 1.0)
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let walls = (2..).zip(&times).map(|(a, &time)| Candidate { time, hit: Hit::WallX(a) });
        let mut engine = Engine::<Lab7, _>::new(One, Choice::Sort, Workers::One);
        let scene = common::hard::Scene::new(10.0, 1.0, vec![Disc::new(5.0, 5.0, 0.0, 0.0); n + 2]);
        engine.load(&scene.expect("all are inside"));
        engine.walls = walls.collect();
        // Not always from the first: what is before another's first wall is another's.
        let begin = random.below(2) * random.below(count);
        let mut next = times.iter().filter(|&&time| time < begin as f64 / count as f64).count();
        for k in begin..count {
            let window = Window::part(k, count);
            let end = if k + 1 == count { 2.0 } else { (k + 1) as f64 / count as f64 };
            let first = next;
            let right = first + times[first..].iter().filter(|&&time| time < end).count();
            let before = engine.taken.len();
            let question = format!("{n} walls, window {k} of {count}, from wall {first} on");
            next = collide_in(&mut engine, window, first);
            let found = vec![next as f64];
            ask(&format!("{question}: the first wall of a later one"), found, vec![right as f64]);
            let mut hits: Vec<f64> =
                engine.taken[before..].iter().map(|c| f64::from(c.hit.first())).collect();
            hits.sort_by(f64::total_cmp);
            // The pair is found in each window, and its discs are free in the first.
            let right = (first..right).map(|wall| (wall + 2) as f64);
            let right = (0..usize::from(k == begin)).map(|_| 0.0).chain(right).collect();
            ask(&format!("{question}: the first discs of what was taken"), hits, right);
        }
    }
}

/// As many candidates as there are, one after the other, into a list behind a lock and into one without.
pub(super) fn appends(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(70_000) {
        let candidates: Vec<Candidate> = (0..n as u32)
            .map(|k| Candidate {
                time: random.between(0.0, 1.0),
                hit: Hit::Pair(k, k + 1 + number(random) / 2),
            })
            .collect();
        let (list, count) = (Slots::default(), LockedCount::default());
        candidates.iter().for_each(|candidate| append_locked(&list, &count, *candidate));
        let (free, shared) = (Slots::default(), SharedCount::default());
        candidates.iter().for_each(|candidate| append_atomic(&free, &shared, *candidate));
        for (how, list, used) in [
            ("under a lock", list, count.locked(|count| *count)),
            ("without a lock", free, shared.load()),
        ] {
            let name = format!("{n} candidates, appended {how}");
            ask(&format!("{name}: slots used"), vec![used as f64], vec![n as f64]);
            let found: Vec<Candidate> = list.first(used.min(2 * n)).collect();
            ask(&format!("{name}: {EACH}"), values(&found), values(&candidates));
        }
    }
}

/// Does what a long run of a variant holds grow?
pub(super) fn long_run(name: &str, ask: Ask<'_>) {
    let variant = VARIANTS.iter().find(|variant| variant.name == name).expect("the lab has it");
    let mut engine = (variant.build)(&variant.config()).expect("it can be built");
    let scene = RandomScene::new(100, 32.0, 1.0, 7).with_speeds(0.5, 3.0).draw();
    let scene = scene.expect("the scene is sound");
    engine.load(&scene);
    let size = (500, size_of_val(scene.discs()));
    memory(name, size, |steps| (0..steps).for_each(|_| engine.step()), ask);
}
