//! A Runge-Kutta method that ends its steps where the motion is not smooth.
//!
//! The motion is not smooth when a pair crosses the cutoff, or when a particle meets a wall. In a
//! step with such a moment, a method of fourth order has first or second order only. This engine
//! finds each such moment and ends the step there. Between two such moments the motion is smooth.
//! Particles that could touch within the step form a group, and each group goes through the step
//! alone. So an event ends only the step of its group.

mod corners;
mod group;
mod groups;

use std::marker::PhantomData;

use common::soft::{DT, Particle, Scene, Simulation};
use neighbour_list::Workers;

use crate::rules::Rules;
use crate::state::State;
use group::Group;
use groups::Groups;

/// Number of times that the allowed speeds may be doubled.
const MOST_TRIES: u32 = 64;
/// Greatest number of pieces that the work of a step is divided into.
const PIECES: usize = 256;
/// Least number of groups in a piece of work.
const IN_A_PIECE: usize = 64;

/// The engine that ends steps at contacts and walls, with the rules `R`.
pub struct Located<R> {
    workers: Workers,
    divide: u32,
    stretch: f64,
    size: f64,
    state: State,
    /// Number of force evaluations, summed over the particles.
    asked: u64,
    events: u64,
    rules: PhantomData<R>,
}

impl<R: Rules> Located<R> {
    /// Makes an engine for `threads` threads. A step is `stretch` official steps long, and is
    /// divided into `divide` small steps.
    pub fn new(threads: usize, divide: u32, stretch: f64) -> Self {
        Self {
            workers: Workers::if_possible(threads),
            divide,
            stretch,
            size: 0.0,
            state: State::default(),
            asked: 0,
            events: 0,
            rules: PhantomData,
        }
    }

    fn one_step(&mut self, dt: f64) {
        let speeds: Vec<f64> = self.state.v.iter().map(|v| v.x.hypot(v.y)).collect();
        // A force may make a particle faster than its allowed speed. Such a particle might have met
        // particles outside its group.
        let mut slack = 1.0;
        for attempt in 1..=MOST_TRIES {
            let allowed: Vec<f64> = speeds.iter().map(|v| slack * (1.25 * v + 0.1)).collect();
            let groups = Groups::new(&self.state.at, &allowed, dt);
            let Some(advanced) = self.advance(&groups, &allowed, dt, attempt == MOST_TRIES) else {
                slack *= 2.0;
                continue;
            };
            for (k, group) in advanced {
                self.asked += group.asked;
                self.events += group.events;
                let moved = group.state.at.iter().zip(&group.state.v);
                for (&i, (&at, &v)) in groups.group(k).0.iter().zip(moved) {
                    self.state.at[i as usize] = at;
                    self.state.v[i as usize] = v;
                }
            }
            return;
        }
    }

    /// Advances each group by a time `dt`, and returns it with its number.
    ///
    /// Returns `None` if a particle is then faster than `allowed`, unless `at_any_speed`.
    fn advance<'a>(
        &self,
        groups: &'a Groups,
        allowed: &[f64],
        dt: f64,
        at_any_speed: bool,
    ) -> Option<Vec<(usize, Group<'a>)>> {
        let per = groups.len().div_ceil(PIECES).max(IN_A_PIECE);
        let pieces = (0..groups.len()).step_by(per).map(|k| k..(k + per).min(groups.len()));
        let pieces = self.workers.map(pieces.collect(), |piece| {
            let mut done = Vec::with_capacity(piece.len());
            for k in piece {
                let (members, pairs) = groups.group(k);
                let mut group = Group::new(&self.state, members, pairs, self.size);
                group.advance::<R>(dt);
                let mut speeds = members.iter().zip(&group.state.v);
                let sound = at_any_speed
                    || pairs.is_empty()
                    || speeds.all(|(&i, v)| v.norm_squared().sqrt() <= allowed[i as usize]);
                if !sound {
                    return None;
                }
                done.push((k, group));
            }
            Some(done)
        });
        Some(pieces.into_iter().collect::<Option<Vec<_>>>()?.into_iter().flatten().collect())
    }
}

impl<R: Rules> Simulation for Located<R> {
    fn load(&mut self, scene: &Scene) {
        self.size = scene.size();
        self.state = State::of(scene);
        self.asked = 0;
        self.events = 0;
    }

    fn step(&mut self) {
        for _ in 0..self.divide {
            self.one_step(self.stretch * DT / f64::from(self.divide));
        }
    }

    fn read(&self, first: usize, out: &mut [Particle]) {
        self.state.read(first, out);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("force evaluations", self.asked as f64 / self.state.at.len() as f64),
            ("events", self.events as f64),
        ]
    }
}
