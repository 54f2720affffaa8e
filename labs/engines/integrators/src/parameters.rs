//! Parameters that the engines of different methods have in common.

use common::Parameter;

/// How many steps an official one is divided into.
pub const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};

/// How many official steps one stands for.
pub const STRETCH: Parameter = Parameter {
    name: "stretch",
    about: "official steps that a step stands for: 2 is a time step of 0.001",
    default: 1.0,
    range: (0.01, 10.0),
};
