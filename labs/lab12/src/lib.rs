//! Lab 12, accurate: how wrong a step is, and what it costs to be less wrong.
//!
//! All labs before this one take the official step and differ in time. Here the step itself
//! changes. A composition of drifts and kicks can have any order, and so can Runge-Kutta, but
//! an order is a promise for smooth motion: our force has a corner at the cutoff, and walls turn
//! velocities round. So one variant finds the moment of each contact and ends its steps there.
//! Another asks the opposite question: which of the sixteen digits does the official step need at
//! all?
//!
//! | task | file | what |
//! |------|------|------|
//! | 12.1 | `composition.rs` | a step of drifts and kicks |
//! | 12.2 | `composition.rs` | velocity Verlet and PEFRL, composed |
//! | 12.3 | `runge_kutta.rs` | the four slopes of a Runge-Kutta step |
//! | 12.4 | `crossing.rs` | the moment at which something falls through zero |
//! | 12.5 | `crossing.rs` | whether something falls within a step, and where to look |
//! | 12.6 | `place.rs` | distances in single precision, wherever in the box |
//!
//! The folders are given and need not be read: `integrators` moves all particles by one of the
//! methods, `located` stops groups of particles at their contacts and walls, `mixed` keeps positions
//! relative to their cells. Cells and threads are those of lab 10.

mod composition;
mod crossing;
mod integrators;
mod located;
mod mixed;
mod place;
mod runge_kutta;
mod state;

pub use composition::{CHI, Composition, LAMBDA, Motion, XI};
pub use crossing::{Watched, crossing, first_fall};
pub use place::{Place, vector};
pub use runge_kutta::slopes;
pub use state::State;

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use integrators::{Integrated, Method};
use located::Located;
use mixed::Mixed;

const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};
const STRETCH: Parameter = Parameter {
    name: "stretch",
    about: "official steps that a step stands for: 2 is a time step of 0.001",
    default: 1.0,
    range: (0.01, 10.0),
};

type Built = Result<Box<dyn Simulation>, BuildError>;

fn divide(config: &Config) -> u32 {
    config.parameter("divide") as u32
}

fn integrated(config: &Config, method: Method) -> Built {
    let stretch = config.parameter("stretch");
    Ok(Box::new(Integrated::new(config.threads, method, divide(config), stretch)))
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "euler",
        about: "kick, then drift: the official step, symplectic Euler, of any length",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Method::Composition(Composition::symplectic_euler())),
    },
    Variant {
        name: "velocity-verlet",
        about: "kick, drift, kick: second order",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Method::Composition(Composition::velocity_verlet())),
    },
    Variant {
        name: "pefrl",
        about: "fourth order, symplectic, four force evaluations a step",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Method::Composition(Composition::pefrl())),
    },
    Variant {
        name: "rk4",
        about: "the classical Runge-Kutta method, four force evaluations a step",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Method::RungeKutta),
    },
    Variant {
        name: "rk4-located",
        about: "Runge-Kutta that ends a step where a pair crosses the cutoff or a wall is met",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| {
            let stretch = config.parameter("stretch");
            Ok(Box::new(Located::new(config.threads, divide(config), stretch)))
        },
    },
    Variant {
        name: "mixed",
        about: "places in single precision relative to their cell, sums and velocities in double",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[DIVIDE],
        build: |config| Ok(Box::new(Mixed::new(config.threads, divide(config)))),
    },
];
