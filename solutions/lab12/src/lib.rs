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
//! | 12.1 | `composition.rs` | a step of drifts and kicks; velocity Verlet and PEFRL, composed |
//! | 12.2 | `runge_kutta.rs` | the four slopes of a Runge-Kutta step |
//! | 12.3 | `crossing.rs` | the moment at which something falls through zero |
//! | 12.4 | `crossing.rs` | whether something falls within a step, and where to look |
//!
//! The rest is the engines of package `integrators`, labs/engines/integrators: they compute forces, move all
//! particles by a method, stop groups of particles at their contacts and walls, or keep positions relative to their cells.
//! `tasks.rs` hands the tasks to them. Their [`State`](integrators::State) and
//! [`Watched`](integrators::Watched) are what tasks 12.2 to 12.4 are given.

mod composition;
mod crossing;
mod runge_kutta;
mod tasks;

pub use composition::{CHI, Composition, LAMBDA, Motion, XI};
pub use crossing::{crossing, first_fall};
pub use runge_kutta::slopes;
pub use tasks::Tasks;

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use integrators::{Integrated, Located, Method, Mixed, RungeKutta};

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

fn integrated(config: &Config, method: impl Method + 'static) -> Built {
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
        build: |config| integrated(config, Composition::symplectic_euler()),
    },
    Variant {
        name: "velocity-verlet",
        about: "kick, drift, kick: second order",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Composition::velocity_verlet()),
    },
    Variant {
        name: "pefrl",
        about: "fourth order, symplectic, four force evaluations a step",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, Composition::pefrl()),
    },
    Variant {
        name: "rk4",
        about: "the classical Runge-Kutta method, four force evaluations a step",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| integrated(config, RungeKutta::<Tasks>::default()),
    },
    Variant {
        name: "rk4-located",
        about: "Runge-Kutta that ends a step where a pair crosses the cutoff or a wall is met",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[DIVIDE, STRETCH],
        build: |config| {
            let stretch = config.parameter("stretch");
            Ok(Box::new(Located::<Tasks>::new(config.threads, divide(config), stretch)))
        },
    },
    Variant {
        name: "mixed",
        about: "positions in single precision relative to their cell, sums and velocities in double",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[DIVIDE],
        build: |config| Ok(Box::new(Mixed::new(config.threads, divide(config)))),
    },
];
