//! Parameters that the engines of different methods have in common.

use common::Parameter;
pub use neighbour_list::DIVIDE;

/// How many official steps one stands for.
pub const STRETCH: Parameter = Parameter {
    name: "stretch",
    about: "official steps that a step stands for: 2 is a time step of 0.001",
    default: 1.0,
    range: (0.01, 10.0),
};
