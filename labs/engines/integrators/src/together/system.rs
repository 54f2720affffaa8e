//! The particles of a box. A method moves all of them together.

use std::marker::PhantomData;

use common::Vec2;
use solution1::bounce;

use super::field::Field;
use crate::rules::Rules;
use crate::state::State;

/// An integration method that moves all particles at the same time.
pub trait Method: Send {
    /// Takes one step of length `dt`, in units of time.
    fn advance(&self, system: &mut System, dt: f64);
}

/// The particles, their box and the forces between them.
pub struct System {
    pub(super) state: State,
    /// Number of times that the forces were computed.
    pub(super) evaluations: u64,
    size: f64,
    field: Field,
    a: Vec<Vec2>,
}

impl System {
    /// Makes an empty system for `threads` threads.
    pub(super) fn new(threads: usize) -> Self {
        Self {
            state: State::default(),
            evaluations: 0,
            size: 0.0,
            field: Field::new(threads),
            a: Vec::new(),
        }
    }

    /// Replaces the particles by the particles in `state`, in a box of side `size`.
    pub(super) fn start(&mut self, state: State, size: f64) {
        self.a = vec![Vec2::ZERO; state.at.len()];
        self.state = state;
        self.size = size;
        self.evaluations = 0;
    }

    /// Moves all particles with their velocities for a time `dt`: x += v dt, with reflection at the
    /// walls.
    pub fn drift(&mut self, dt: f64) {
        for (at, v) in self.state.at.iter_mut().zip(&mut self.state.v) {
            (at.x, v.x) = bounce(at.x + v.x * dt, v.x, self.size);
            (at.y, v.y) = bounce(at.y + v.y * dt, v.y, self.size);
        }
    }

    /// Applies the forces at the current positions to all velocities for a time `dt`: v += a dt.
    pub fn kick(&mut self, dt: f64) {
        self.field.accelerations(&self.state.at, &mut self.a);
        self.evaluations += 1;
        for (v, &a) in self.state.v.iter_mut().zip(&self.a) {
            *v += dt * a;
        }
    }
}

/// The classical Runge-Kutta method of fourth order, with the slopes of `R`.
///
/// The stages may put particles outside the walls. Only the result of the whole step is reflected.
pub struct RungeKutta<R>(PhantomData<R>);

impl<R> Default for RungeKutta<R> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<R: Rules> Method for RungeKutta<R> {
    fn advance(&self, system: &mut System, dt: f64) {
        let System { state, field, evaluations, size, .. } = system;
        let sum = R::slopes(state, dt, &mut |at, a| {
            field.accelerations(at, a);
            *evaluations += 1;
        });
        let changes = sum.at.iter().zip(&sum.v);
        for ((at, v), (way, change)) in state.at.iter_mut().zip(&mut state.v).zip(changes) {
            (at.x, v.x) = bounce(at.x + way.x * dt / 6.0, v.x + change.x * dt / 6.0, *size);
            (at.y, v.y) = bounce(at.y + way.y * dt / 6.0, v.y + change.y * dt / 6.0, *size);
        }
    }
}
