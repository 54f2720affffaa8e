//! Runge-Kutta that stops where the force has a corner.
//!
//! Within a step in which a pair crosses the cutoff, or a particle meets a wall, the motion is not
//! smooth and a method of fourth order is one of first or second. Here each such moment is found
//! and the step is ended there; between two moments it is smooth. Only those concerned are
//! stopped: who could touch within the step forms a group, and groups go through it on their own.

use common::Vec2;
use common::soft::{CUTOFF, DT, MASS, MIN_R, Particle, Scene, Simulation};
use solution1::bounce;

use crate::event::{Watched, first_fall};
use crate::near::Groups;
use crate::{Bodies, Workers};

/// Larger groups are crowds: nobody can follow their events one by one, and they are not stopped.
const MOST_MEMBERS: usize = 64;
/// Who has met so many events in one step is not stopped any more.
const MOST_EVENTS: u32 = 64;
/// How often the speeds that are allowed for may be doubled.
const MOST_TRIES: u32 = 64;

/// The engine of variant `rk4-located`.
pub struct Located {
    workers: Workers,
    divide: u32,
    stretch: f64,
    size: f64,
    bodies: Bodies,
    /// Particles that were asked for their force, summed over all the times when somebody was.
    asked: u64,
    events: u64,
}

/// Something that ends a step.
#[derive(Clone, Copy)]
enum Event {
    /// The pair with this number comes into reach or leaves it.
    Pair(usize),
    /// A particle meets the wall at 0 or at the far end, along x or y.
    Wall { particle: usize, along_x: bool, far: bool },
}

/// Particles that may touch each other, on their way through a step.
struct Group<'a> {
    size: f64,
    pairs: &'a [(u32, u32)],
    /// Whether each pair is in reach. Its force has the same formula on both sides of the cutoff
    /// until the event, so that nothing has a corner.
    touching: Vec<bool>,
    at: Vec<Vec2>,
    v: Vec<Vec2>,
    asked: u64,
    events: u64,
}

impl Located {
    /// An engine for `threads` threads whose step is `stretch` official ones, done in `divide`.
    pub fn new(threads: usize, divide: u32, stretch: f64) -> Self {
        let (bodies, workers) = (Bodies::default(), Workers::new(threads));
        Self { workers, divide, stretch, size: 0.0, bodies, asked: 0, events: 0 }
    }

    fn one_step(&mut self, dt: f64) {
        let bodies = &self.bodies;
        let speeds: Vec<f64> =
            bodies.vx.iter().zip(&bodies.vy).map(|(vx, vy)| vx.hypot(*vy)).collect();
        // A push may make somebody faster than was allowed for: then it might have met more.
        let mut slack = 1.0;
        for attempt in 0..MOST_TRIES {
            let allowed: Vec<f64> = speeds.iter().map(|v| slack * (1.25 * v + 0.1)).collect();
            let groups = Groups::new(bodies, &allowed, dt);
            let last = attempt + 1 == MOST_TRIES;
            let per = groups.len().div_ceil(256).max(64);
            let pieces = (0..groups.len()).step_by(per).map(|k| k..(k + per).min(groups.len()));
            let pieces = self.workers.map(pieces.collect(), |piece| {
                let mut done = Vec::new();
                for k in piece {
                    let (members, pairs) = groups.group(k);
                    let mut group = Group::new(bodies, members, pairs, self.size);
                    group.advance(dt);
                    let sound =
                        |(&i, v): (&u32, &Vec2)| v.norm_squared().sqrt() <= allowed[i as usize];
                    if !last && !pairs.is_empty() && !members.iter().zip(&group.v).all(sound) {
                        return None;
                    }
                    done.push((k, group));
                }
                Some(done)
            });
            let Some(pieces) = pieces.into_iter().collect::<Option<Vec<_>>>() else {
                slack *= 2.0;
                continue;
            };
            let mut next = bodies.clone();
            for (k, group) in pieces.into_iter().flatten() {
                for ((&i, at), v) in groups.group(k).0.iter().zip(&group.at).zip(&group.v) {
                    let i = i as usize;
                    (next.x[i], next.y[i], next.vx[i], next.vy[i]) = (at.x, at.y, v.x, v.y);
                }
                self.asked += group.asked;
                self.events += group.events;
            }
            self.bodies = next;
            return;
        }
    }
}

impl<'a> Group<'a> {
    fn new(bodies: &Bodies, members: &[u32], pairs: &'a [(u32, u32)], size: f64) -> Self {
        let members = || members.iter().map(|&i| i as usize);
        let at = members().map(|i| Vec2::new(bodies.x[i], bodies.y[i])).collect();
        let v = members().map(|i| Vec2::new(bodies.vx[i], bodies.vy[i])).collect();
        let mut group =
            Self { size, pairs, touching: vec![false; pairs.len()], at, v, asked: 0, events: 0 };
        group.see_who_touches();
        group
    }

    fn see_who_touches(&mut self) {
        for (touching, &(a, b)) in self.touching.iter_mut().zip(self.pairs) {
            let d = self.at[b as usize] - self.at[a as usize];
            *touching = d.norm_squared() <= CUTOFF * CUTOFF;
        }
    }

    fn advance(&mut self, dt: f64) {
        let mut left = dt;
        if self.pairs.is_empty() {
            // Nobody to meet: free flight needs no force.
            (self.at, self.v) = (vec![self.at[0] + left * self.v[0]], vec![self.v[0]]);
        } else if self.at.len() > MOST_MEMBERS {
            (self.at, self.v) = self.step(left);
        } else {
            for _ in 0..MOST_EVENTS {
                let end = self.step(left);
                let Some((time, event)) = self.first_event(&end, left) else {
                    (self.at, self.v, left) = (end.0, end.1, 0.0);
                    break;
                };
                if time > 0.0 {
                    (self.at, self.v) = self.step(time);
                    left = (left - time).max(0.0);
                }
                self.happen(event);
            }
            if left > 0.0 {
                self.see_who_touches();
                (self.at, self.v) = self.step(left);
            }
        }
        for (at, v) in self.at.iter_mut().zip(&mut self.v) {
            (at.x, v.x) = bounce(at.x, v.x, self.size);
            (at.y, v.y) = bounce(at.y, v.y, self.size);
        }
    }

    /// One step of the classical Runge-Kutta method from here, not taken.
    fn step(&mut self, h: f64) -> (Vec<Vec2>, Vec<Vec2>) {
        let n = self.at.len();
        let (mut at, mut v) = (self.at.clone(), self.v.clone());
        let (mut way, mut change) = (vec![Vec2::ZERO; n], vec![Vec2::ZERO; n]);
        let mut a = vec![Vec2::ZERO; n];
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            self.accelerations(&at, &mut a);
            self.asked += n as u64;
            for i in 0..n {
                way[i] += weight * v[i];
                change[i] += weight * a[i];
                at[i] = self.at[i] + (next * h) * v[i];
                v[i] = self.v[i] + (next * h) * a[i];
            }
        }
        for i in 0..n {
            at[i] = self.at[i] + (h / 6.0) * way[i];
            v[i] = self.v[i] + (h / 6.0) * change[i];
        }
        (at, v)
    }

    fn accelerations(&self, at: &[Vec2], a: &mut [Vec2]) {
        a.fill(Vec2::ZERO);
        for (&(i, j), _) in self.pairs.iter().zip(&self.touching).filter(|(_, touch)| **touch) {
            let (i, j) = (i as usize, j as usize);
            let d = at[j] - at[i];
            let squared = d.norm_squared().max(MIN_R * MIN_R);
            let push = ((1.0 - CUTOFF / squared.sqrt()) / squared / MASS) * d;
            a[i] += push;
            a[j] -= push;
        }
    }

    fn first_event(&mut self, end: &(Vec<Vec2>, Vec<Vec2>), h: f64) -> Option<(f64, Event)> {
        let walls = (0..self.at.len()).flat_map(|particle| {
            [(true, true), (true, false), (false, true), (false, false)]
                .map(|(along_x, far)| Event::Wall { particle, along_x, far })
        });
        let mut first: Option<(f64, Event)> = None;
        for event in (0..self.pairs.len()).map(Event::Pair).chain(walls) {
            let (start, end) =
                (self.watch(event, &self.at, &self.v), self.watch(event, &end.0, &end.1));
            let found = first_fall(start, end, h, &mut |t| match t {
                0.0 => start,
                t if t == h => end,
                t => {
                    let (at, v) = self.step(t);
                    self.watch(event, &at, &v)
                }
            });
            // Numbers may overflow: then there is no moment.
            if let Some(time) = found.filter(|time| time.is_finite())
                && first.is_none_or(|(earliest, _)| time < earliest)
            {
                first = Some((time, event));
            }
        }
        first
    }

    fn watch(&self, event: Event, at: &[Vec2], v: &[Vec2]) -> Watched {
        match event {
            Event::Pair(k) => {
                let (a, b) = (self.pairs[k].0 as usize, self.pairs[k].1 as usize);
                let (d, w) = (at[b] - at[a], v[b] - v[a]);
                let sign = if self.touching[k] { -1.0 } else { 1.0 };
                let value = sign * (d.norm_squared() - CUTOFF * CUTOFF);
                Watched { value, slope: sign * 2.0 * d.dot(w) }
            }
            Event::Wall { particle, along_x, far } => {
                let (at, v) = (at[particle], v[particle]);
                let (x, v) = if along_x { (at.x, v.x) } else { (at.y, v.y) };
                if far {
                    Watched { value: self.size - x, slope: -v }
                } else {
                    Watched { value: x, slope: v }
                }
            }
        }
    }

    fn happen(&mut self, event: Event) {
        self.events += 1;
        match event {
            Event::Pair(k) => self.touching[k] = !self.touching[k],
            Event::Wall { particle, along_x, far } => {
                let wall = if far { self.size } else { 0.0 };
                let (at, v) = (&mut self.at[particle], &mut self.v[particle]);
                if along_x {
                    (at.x, v.x) = (wall, -v.x);
                } else {
                    (at.y, v.y) = (wall, -v.y);
                }
            }
        }
    }
}

impl Simulation for Located {
    fn load(&mut self, scene: &Scene) {
        (self.size, self.bodies) = (scene.size(), Bodies::of(scene));
        (self.asked, self.events) = (0, 0);
    }

    fn step(&mut self) {
        for _ in 0..self.divide {
            self.one_step(self.stretch * DT / f64::from(self.divide));
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.bodies.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("force evaluations", self.asked as f64 / self.bodies.len() as f64),
            ("events", self.events as f64),
        ]
    }
}
