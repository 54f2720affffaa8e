//! The path of a group of particles through a step, from event to event.

use solution1::bounce;

use super::corners::{Corners, Event};
use crate::rules::Rules;
use crate::state::State;

/// Greatest number of members of a group whose events are followed. A larger group has too many
/// events.
const MOST_MEMBERS: usize = 64;
/// Number of events in a step after which a group takes the rest of the step as a single step.
const MOST_EVENTS: u32 = 64;

/// Particles that may touch each other.
pub(super) struct Group<'a> {
    pub(super) state: State,
    /// Number of force evaluations, summed over the particles.
    pub(super) asked: u64,
    /// Number of events.
    pub(super) events: u64,
    size: f64,
    corners: Corners<'a>,
}

impl<'a> Group<'a> {
    /// Makes a group of the particles `members` of `all`, and of their pairs that could touch.
    pub(super) fn new(all: &State, members: &[u32], pairs: &'a [(u32, u32)], size: f64) -> Self {
        let state = State {
            at: members.iter().map(|&i| all.at[i as usize]).collect(),
            v: members.iter().map(|&i| all.v[i as usize]).collect(),
        };
        let corners = Corners::new(pairs, size, &state);
        Self { state, asked: 0, events: 0, size, corners }
    }

    /// Advances the group by a time `dt`, and ends a step at each event.
    pub(super) fn advance<R: Rules>(&mut self, dt: f64) {
        let mut left = dt;
        if self.corners.is_alone() {
            // A single particle has no pairs and so no forces: it flies freely.
            self.state.at[0] += left * self.state.v[0];
        } else if self.state.at.len() > MOST_MEMBERS {
            self.state = self.step::<R>(left);
        } else {
            for _ in 0..MOST_EVENTS {
                let end = self.step::<R>(left);
                let Some((time, event)) = self.first_event::<R>(&end, left) else {
                    self.state = end;
                    left = 0.0;
                    break;
                };
                if time > 0.0 {
                    self.state = self.step::<R>(time);
                    left = (left - time).max(0.0);
                }
                self.corners.happen(event, &mut self.state);
                self.events += 1;
            }
            if left > 0.0 {
                self.corners.see_contacts(&self.state);
                self.state = self.step::<R>(left);
            }
        }
        for (at, v) in self.state.at.iter_mut().zip(&mut self.state.v) {
            (at.x, v.x) = bounce(at.x, v.x, self.size);
            (at.y, v.y) = bounce(at.y, v.y, self.size);
        }
    }

    fn first_event<R: Rules>(&mut self, end: &State, h: f64) -> Option<(f64, Event)> {
        let Self { state, corners, asked, .. } = self;
        corners.first_event::<R>(state, end, h, &mut |t| runge_kutta::<R>(corners, state, t, asked))
    }

    /// Returns the state after a step of the classical Runge-Kutta method, without moving the
    /// group.
    fn step<R: Rules>(&mut self, h: f64) -> State {
        runge_kutta::<R>(&self.corners, &self.state, h, &mut self.asked)
    }
}

fn runge_kutta<R: Rules>(corners: &Corners<'_>, start: &State, h: f64, asked: &mut u64) -> State {
    let sum = R::slopes(start, h, &mut |at, a| {
        corners.accelerations(at, a);
        *asked += at.len() as u64;
    });
    start.along(&sum, h / 6.0)
}
