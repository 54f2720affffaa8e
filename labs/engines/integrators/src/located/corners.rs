//! Events: the moments at which the motion of a group is not smooth.
//!
//! An event is a pair at the cutoff, or a particle at a wall.

use common::Vec2;
use common::soft::{CUTOFF, MASS, MIN_R};

use crate::rules::{Rules, Watched};
use crate::state::State;

/// An event that ends a step.
#[derive(Clone, Copy)]
pub(super) enum Event {
    /// The pair with this number comes within the cutoff or leaves it.
    Pair(usize),
    /// A particle meets the wall at 0 or at the far end, along x or y.
    Wall { particle: usize, along_x: bool, far: bool },
}

/// The walls and pairs of a group.
pub(super) struct Corners<'a> {
    size: f64,
    pairs: &'a [(u32, u32)],
    /// Whether each pair exerts a force. Until its next event, a pair's force follows one formula
    /// on both sides of the cutoff, so that the motion between events is smooth.
    touching: Vec<bool>,
}

impl<'a> Corners<'a> {
    /// Collects the causes of events: the walls of a box of side `size`, and these pairs of the
    /// group. The pairs that are within the cutoff in `state` exert forces.
    pub(super) fn new(pairs: &'a [(u32, u32)], size: f64, state: &State) -> Self {
        let mut corners = Self { size, pairs, touching: vec![false; pairs.len()] };
        corners.see_contacts(state);
        corners
    }

    /// Whether there are no pairs.
    pub(super) fn is_alone(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Lets exactly the pairs within the cutoff exert forces.
    pub(super) fn see_contacts(&mut self, state: &State) {
        for (touching, &(a, b)) in self.touching.iter_mut().zip(self.pairs) {
            let d = state.at[b as usize] - state.at[a as usize];
            *touching = d.norm_squared() <= CUTOFF * CUTOFF;
        }
    }

    /// Writes the accelerations due to the touching pairs to `a`.
    pub(super) fn accelerations(&self, at: &[Vec2], a: &mut [Vec2]) {
        a.fill(Vec2::ZERO);
        for (&(i, j), _) in self.pairs.iter().zip(&self.touching).filter(|(_, touch)| **touch) {
            let [i, j] = [i, j].map(|k| k as usize);
            let d = at[j] - at[i];
            let squared = d.norm_squared().max(MIN_R * MIN_R);
            let pair = ((1.0 - CUTOFF / squared.sqrt()) / squared / MASS) * d;
            a[i] += pair;
            a[j] -= pair;
        }
    }

    /// Returns the first event on the path from `start` to `end`, and its time, or `None`.
    ///
    /// The path takes a time `h`, and `at` computes any state on it.
    pub(super) fn first_event<R: Rules>(
        &self,
        start: &State,
        end: &State,
        h: f64,
        at: &mut dyn FnMut(f64) -> State,
    ) -> Option<(f64, Event)> {
        let walls = (0..start.at.len()).flat_map(|particle| {
            [(true, true), (true, false), (false, true), (false, false)]
                .map(|(along_x, far)| Event::Wall { particle, along_x, far })
        });
        let mut first: Option<(f64, Event)> = None;
        for event in (0..self.pairs.len()).map(Event::Pair).chain(walls) {
            let start = self.watch(event, start);
            let end = self.watch(event, end);
            let found = R::first_fall(start, end, h, &mut |t| match t {
                0.0 => start,
                t if t == h => end,
                t => self.watch(event, &at(t)),
            });
            // If numbers overflow, the time is not finite, and there is no event.
            if let Some(time) = found.filter(|time| time.is_finite())
                && first.is_none_or(|(earliest, _)| time < earliest)
            {
                first = Some((time, event));
            }
        }
        first
    }

    fn watch(&self, event: Event, State { at, v }: &State) -> Watched {
        match event {
            Event::Pair(k) => {
                let (a, b) = self.pairs[k];
                let d = at[b as usize] - at[a as usize];
                let w = v[b as usize] - v[a as usize];
                let sign = if self.touching[k] { -1.0 } else { 1.0 };
                let value = sign * (d.norm_squared() - CUTOFF * CUTOFF);
                Watched { value, slope: sign * 2.0 * d.dot(w) }
            }
            Event::Wall { particle, along_x, far } => {
                let at = at[particle];
                let v = v[particle];
                let (x, v) = if along_x { (at.x, v.x) } else { (at.y, v.y) };
                if far {
                    Watched { value: self.size - x, slope: -v }
                } else {
                    Watched { value: x, slope: v }
                }
            }
        }
    }

    /// Carries out an event: the force of a pair begins or ends, or a velocity is reflected.
    pub(super) fn happen(&mut self, event: Event, state: &mut State) {
        match event {
            Event::Pair(k) => self.touching[k] = !self.touching[k],
            Event::Wall { particle, along_x, far } => {
                let wall = if far { self.size } else { 0.0 };
                let at = &mut state.at[particle];
                let v = &mut state.v[particle];
                if along_x {
                    at.x = wall;
                    v.x = -v.x;
                } else {
                    at.y = wall;
                    v.y = -v.y;
                }
            }
        }
    }
}
