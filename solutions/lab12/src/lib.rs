//! Lab 12, integrators and their error: the solution. The lab is described in `labs/lab12/README.md`.

mod composition;
mod crossing;
mod runge_kutta;
mod tasks;

pub use composition::{CHI, Composition, LAMBDA, Motion, XI};
pub use crossing::{crossing, first_fall};
pub use runge_kutta::slopes;
pub use tasks::Tasks;

use common::soft::Simulation;
use common::{BuildError, Config, Reproducibility, Variant};
use integrators::{DIVIDE, Integrated, Located, Method, Mixed, RungeKutta, STRETCH};

type Built = Result<Box<dyn Simulation>, BuildError>;

fn divide(config: &Config) -> u32 {
    config.parameter("divide") as u32
}

fn integrated(config: &Config, method: impl Method + 'static) -> Built {
    let stretch = config.parameter("stretch");
    Ok(Box::new(Integrated::new(config.threads, method, divide(config), stretch)))
}

/// Makes a variant that gives the same bits in every run.
const fn variant(
    name: &'static str,
    about: &'static str,
    build: fn(&Config) -> Built,
) -> Variant<dyn Simulation> {
    let (reproducibility, parameters) = (Reproducibility::Deterministic, &[DIVIDE, STRETCH]);
    Variant { name, about, reproducibility, parameters, build }
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    variant(
        "euler",
        "kick, then drift: the official step, symplectic Euler, of any length",
        |config| integrated(config, Composition::symplectic_euler()),
    ),
    variant("velocity-verlet", "kick, drift, kick: second order", |config| {
        integrated(config, Composition::velocity_verlet())
    }),
    variant("pefrl", "fourth order, symplectic, four force evaluations a step", |config| {
        integrated(config, Composition::pefrl())
    }),
    variant("rk4", "the classical Runge-Kutta method, four force evaluations a step", |config| {
        integrated(config, RungeKutta::<Tasks>::default())
    }),
    variant(
        "rk4-located",
        "Runge-Kutta that ends a step where a pair crosses the cutoff or a wall is met",
        |config| {
            let stretch = config.parameter("stretch");
            Ok(Box::new(Located::<Tasks>::new(config.threads, divide(config), stretch)))
        },
    ),
    Variant {
        name: "mixed",
        about: "positions in single precision relative to their cell, sums and velocities in double",
        reproducibility: Reproducibility::Tolerance,
        parameters: &[DIVIDE],
        build: |config| Ok(Box::new(Mixed::new(config.threads, divide(config)))),
    },
];
