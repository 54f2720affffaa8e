//! The MPI launcher of this machine, and the flags that let it start more ranks than cores.

use std::env;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::Duration;

use thiserror::Error;

/// A working `mpiexec`, with the flags that it needs on a small machine or in a container.
#[derive(Clone, Debug)]
pub struct Mpiexec {
    program: OsString,
    flags: &'static [&'static str],
    /// Whether a waiting rank yields its core to another rank.
    yields: bool,
}

/// Factor by which time limits grow if ranks outnumber the cores and do not yield them.
const PATIENCE: u32 = 4;

/// The reason why no `mpiexec` works.
#[derive(Debug, Error)]
#[error("cannot run '{}' ({reason}): install an MPI with scripts/setup.sh, or set MPIEXEC", .program.display())]
pub struct NoMpiexec {
    program: OsString,
    reason: io::Error,
}

impl Mpiexec {
    /// Finds the launcher that `MPIEXEC` names, or else a launcher beside the compiler, or else
    /// `mpiexec`.
    ///
    /// `MPICC` names the compiler that the labs were built with. The launcher and the compiler must
    /// belong to the same MPI library.
    ///
    /// # Errors
    /// The launcher is missing or does not start.
    pub fn find() -> Result<Self, NoMpiexec> {
        let program = env::var_os("MPIEXEC")
            .or_else(|| beside(Path::new(&env::var_os("MPICC")?)))
            .unwrap_or_else(|| "mpiexec".into());
        match Command::new(&program).arg("--version").output() {
            Ok(output) => {
                let flags = flags(&String::from_utf8_lossy(&output.stdout));
                Ok(Self { program, flags, yields: !flags.is_empty() })
            }
            Err(reason) => Err(NoMpiexec { program, reason }),
        }
    }

    /// Returns the time limit of a job on `ranks` ranks.
    ///
    /// The job takes at most `usual` if waiting ranks yield their cores.
    ///
    /// With Debian's MPICH they do not: a rank polls for messages until the system takes its core
    /// away, after three or four milliseconds. A message to a rank without a core then takes that
    /// long.
    pub fn limit(&self, usual: Duration, ranks: usize) -> Duration {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        if self.yields || ranks <= cores { usual } else { PATIENCE * usual }
    }

    /// Returns the command that runs `program` on `ranks` ranks. The caller may append the
    /// program's arguments.
    pub fn start(&self, ranks: usize, program: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.args(self.flags).arg("-n").arg(ranks.to_string()).arg(program);
        command
    }
}

/// Returns the launcher of a compiler: `/opt/mpi/bin/mpiexec` for `/opt/mpi/bin/mpicc`.
///
/// Returns `None` for a name without `mpicc`.
fn beside(compiler: &Path) -> Option<OsString> {
    let name = compiler.file_name()?.to_str()?;
    let launcher = name.replacen("mpicc", "mpiexec", 1);
    (launcher != name).then(|| PathBuf::from(compiler).with_file_name(launcher).into())
}

/// Returns the flags that a launcher with this version text needs.
///
/// Open MPI refuses to run as root and to start more ranks than cores, and it binds each rank to one core, which two
/// threads of the rank would share. Version 5 spells its flags differently. MPICH, and the launchers made from it, need
/// no flags.
fn flags(version: &str) -> &'static [&'static str] {
    if version.contains("OpenRTE") {
        &["--oversubscribe", "--bind-to", "none", "--allow-run-as-root"]
    } else if version.contains("Open MPI") {
        &["--map-by", ":OVERSUBSCRIBE", "--bind-to", "none", "--allow-run-as-root"]
    } else {
        &[]
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{beside, flags};

    #[test]
    fn each_mpi_gets_its_flags() {
        assert!(flags("mpiexec (OpenRTE) 4.1.4\n").contains(&"--oversubscribe"));
        assert!(flags("mpirun (Open MPI) 5.0.3\n").contains(&":OVERSUBSCRIBE"));
        assert!(flags("HYDRA build details:\n    Version: 4.0.2\n").is_empty());
    }

    #[test]
    fn launcher_and_compiler_are_of_one_family() {
        for (compiler, launcher) in [
            ("mpicc", Some("mpiexec")),
            ("mpicc.mpich", Some("mpiexec.mpich")),
            ("/usr/bin/gcc", None),
            ("/opt/mpi/bin/mpicc", Some("/opt/mpi/bin/mpiexec")),
        ] {
            assert_eq!(beside(Path::new(compiler)), launcher.map(Into::into), "{compiler}");
        }
    }
}
