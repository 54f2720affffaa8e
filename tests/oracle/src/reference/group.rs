//! A few particles that may be in contact, followed from event to event.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R, Particle};

use super::event::{Watched, first_fall};
use super::extrapolation::{State, step};

/// Greatest number of halvings of a step. If a step needs more halvings, the motion is not smooth.
const MOST_HALVINGS: u32 = 40;

/// Particles of a group, its pairs, and the pairs in contact.
pub(super) struct Group {
    size: f64,
    state: State,
    pairs: Vec<(usize, usize)>,
    touching: Vec<bool>,
}

/// A kind of event. Each occurs when a certain quantity falls through zero.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// The pair with this number comes within reach or leaves it.
    Pair(usize),
    /// A particle reaches the wall at 0 or at the far end, along x or y.
    Wall { particle: usize, along_x: bool, far: bool },
}

impl Group {
    pub(super) fn new(particles: impl Iterator<Item = Particle>, size: f64) -> Self {
        let mut state = State::default();
        for p in particles {
            state.at.push(Vec2::new(p.x, p.y));
            state.v.push(Vec2::new(p.vx, p.vy));
        }
        let n = state.at.len();
        let pairs: Vec<_> = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b))).collect();
        let touching = pairs
            .iter()
            .map(|&(a, b)| (state.at[b] - state.at[a]).norm_squared() <= CUTOFF * CUTOFF)
            .collect();
        Self { size, state, pairs, touching }
    }

    /// Returns positions and velocities.
    pub(super) fn particles(&self) -> impl Iterator<Item = (Vec2, Vec2)> {
        self.state.at.iter().copied().zip(self.state.v.iter().copied())
    }

    /// Advances by `time`. Returns the greatest speed during this time.
    pub(super) fn advance(&mut self, time: f64, tolerance: f64) -> Result<f64, String> {
        let mut left = time;
        let mut fastest = self.fastest();
        while left > 0.0 {
            let (mut h, mut halvings) = (left, 0);
            let (mut end, mut error) = self.step(h);
            while error.is_nan() || error > tolerance {
                h *= 0.5;
                halvings += 1;
                if halvings > MOST_HALVINGS {
                    return Err("the motion is not smooth: no step is short enough".into());
                }
                (end, error) = self.step(h);
            }
            let event = self.first_event(&end, h);
            if let Some((time, event)) = event {
                h = time;
                if h > 0.0 {
                    self.state = self.step(h).0;
                }
                self.happen(event);
            } else {
                self.state = end;
            }
            self.check_distances()?;
            fastest = fastest.max(self.fastest());
            // After the last step the remaining time is exactly zero, regardless of rounding.
            left = if h == left { 0.0 } else { left - h };
        }
        Ok(fastest)
    }

    fn fastest(&self) -> f64 {
        self.state.v.iter().map(|v| v.norm_squared()).fold(0.0, f64::max).sqrt()
    }

    fn step(&self, h: f64) -> (State, f64) {
        step(&self.state, h, &|at, a| self.accelerations(at, a))
    }

    /// Computes the forces of the pairs in contact. The formula is the same on both sides of the
    /// cutoff, so that the force is smooth until the next event.
    fn accelerations(&self, at: &[Vec2], a: &mut [Vec2]) {
        a.fill(Vec2::ZERO);
        for (&(i, j), _) in self.pairs.iter().zip(&self.touching).filter(|(_, touch)| **touch) {
            let d = at[j] - at[i];
            let squared = d.norm_squared();
            let acceleration = ((1.0 - CUTOFF / squared.sqrt()) / squared / MASS) * d;
            a[i] += acceleration;
            a[j] -= acceleration;
        }
    }

    fn check_distances(&self) -> Result<(), String> {
        let close = self
            .pairs
            .iter()
            .find(|&&(a, b)| (self.state.at[b] - self.state.at[a]).norm_squared() < MIN_R * MIN_R);
        match close {
            Some(_) => Err(format!("two particles came closer than {MIN_R}: no exact motion")),
            None => Ok(()),
        }
    }

    fn first_event(&self, end: &State, h: f64) -> Option<(f64, Event)> {
        let mut first: Option<(f64, Event)> = None;
        for event in self.events() {
            let (a, b) = (self.watch(event, &self.state), self.watch(event, end));
            let found = first_fall(a, b, h, |t| match t {
                0.0 => a,
                t if t == h => b,
                t => self.watch(event, &self.step(t).0),
            });
            if let Some(time) = found
                && first.is_none_or(|(earliest, _)| time < earliest)
            {
                first = Some((time, event));
            }
        }
        first
    }

    fn events(&self) -> impl Iterator<Item = Event> {
        let walls = (0..self.state.at.len()).flat_map(|particle| {
            [(true, true), (true, false), (false, true), (false, false)]
                .map(|(along_x, far)| Event::Wall { particle, along_x, far })
        });
        (0..self.pairs.len()).map(Event::Pair).chain(walls)
    }

    fn watch(&self, event: Event, state: &State) -> Watched {
        match event {
            Event::Pair(k) => {
                let (a, b) = self.pairs[k];
                let (d, w) = (state.at[b] - state.at[a], state.v[b] - state.v[a]);
                let value = d.norm_squared() - CUTOFF * CUTOFF;
                let slope = 2.0 * (d.x * w.x + d.y * w.y);
                let sign = if self.touching[k] { -1.0 } else { 1.0 };
                Watched { value: sign * value, slope: sign * slope }
            }
            Event::Wall { particle, along_x, far } => {
                let (at, v) = (state.at[particle], state.v[particle]);
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
        match event {
            Event::Pair(k) => self.touching[k] = !self.touching[k],
            Event::Wall { particle, along_x, far } => {
                let wall = if far { self.size } else { 0.0 };
                let (at, v) = (&mut self.state.at[particle], &mut self.state.v[particle]);
                if along_x {
                    (at.x, v.x) = (wall, -v.x);
                } else {
                    (at.y, v.y) = (wall, -v.y);
                }
            }
        }
    }
}
