//! How LAMMPS can be set up: what a user who wants speed would try.

use std::fmt;
use std::process::Command;

use clap::{Args, ValueEnum};
use serde::Serialize;

use super::install::Installed;

/// How LAMMPS computes the force of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(super) enum Style {
    /// By the formula.
    Lepton,
    /// Between 20,000 values, in a straight line over the squared distance.
    Table,
}

/// One way to run it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Setup {
    pub(super) style: Style,
    pub(super) skin: f64,
    /// It sorts its particles at the first new list after this number of steps.
    pub(super) sort: u32,
}

/// What is tried.
#[derive(Args)]
pub(super) struct Tried {
    /// LAMMPS's pair styles
    #[arg(long, value_name = "STYLE", value_delimiter = ',', default_values = ["lepton", "table"])]
    pub(super) styles: Vec<Style>,
    /// LAMMPS's skins to try
    #[arg(long, value_name = "SKIN", value_delimiter = ',', default_values_t = [0.01, 0.015, 0.02])]
    skins: Vec<f64>,
    /// Steps after which LAMMPS sorts its particles, to try
    #[arg(long, value_name = "STEPS", value_delimiter = ',', default_values_t = [20, 100])]
    sorts: Vec<u32>,
    /// How often each setup is tried before the best of each style takes part
    #[arg(long, default_value_t = 2, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) tries: u16,
}

impl Tried {
    /// Every style with every skin and every sort.
    pub(super) fn setups(&self) -> Vec<Setup> {
        let mut setups = Vec::new();
        for &style in &self.styles {
            for &skin in &self.skins {
                setups.extend(self.sorts.iter().map(|&sort| Setup { style, skin, sort }));
            }
        }
        setups
    }
}

impl Style {
    /// The setup that trajectories and forces are taken with; they hardly depend on it.
    pub(super) fn usual(self) -> Setup {
        Setup { style: self, skin: 0.01, sort: 20 }
    }
}

impl Setup {
    /// The command that runs our script with it; what to do may follow.
    pub(super) fn command(&self, lammps: &Installed, ranks: u16) -> Command {
        let mut command = lammps.script(ranks);
        command.args([self.style.to_string(), self.skin.to_string(), self.sort.to_string()]);
        command
    }
}

impl fmt::Display for Style {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lepton => "lepton",
            Self::Table => "table",
        })
    }
}

impl fmt::Display for Setup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { style, skin, sort } = self;
        write!(f, "LAMMPS {style}, skin {skin}, sort {sort}")
    }
}
