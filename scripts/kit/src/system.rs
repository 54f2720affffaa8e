//! Software that a lab needs in addition to Rust.

use std::ffi::OsStr;
use std::path::Path;

use anyhow::{Result, ensure};
use lab_machine::Mpiexec;

use crate::facts::Workers;
use crate::kit::Kit;
use crate::lab::Lab;

/// Returns the software that must be installed before the lab can run; `None` if nothing is
/// missing.
pub fn missing(kit: &Kit, lab: Lab) -> Result<Option<&'static str>> {
    Ok(match kit.facts(lab)?.workers {
        Workers::Ranks if !has_mpi() => Some(
            "an MPI library: scripts/setup.sh installs it (Debian, Ubuntu: libopenmpi-dev openmpi-bin libclang-dev; macOS: open-mpi llvm)",
        ),
        Workers::Device if cfg!(target_os = "linux") && !has_library("libvulkan.so.1") => Some(
            "a Vulkan driver: scripts/setup.sh installs it (Debian, Ubuntu: libvulkan1 mesa-vulkan-drivers)",
        ),
        _ => None,
    })
}

/// Returns an error if software must be installed before the lab can run.
pub fn expect(kit: &Kit, lab: Lab) -> Result<()> {
    let missing = missing(kit, lab)?;
    ensure!(missing.is_none(), "lab {lab} needs {}", missing.unwrap_or_default());
    Ok(())
}

/// Whether the build and the tests find an MPI compiler and a launcher.
fn has_mpi() -> bool {
    let compiler = std::env::var_os("MPICC").unwrap_or_else(|| "mpicc".into());
    (on_path(&compiler) || Path::new(&compiler).is_file()) && Mpiexec::find().is_ok()
}

/// Whether a program is on the path.
pub fn on_path(program: &OsStr) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(program).is_file())
}

fn has_library(name: &str) -> bool {
    let loader = std::env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let architecture = format!("{}-linux-gnu", std::env::consts::ARCH);
    ["/lib", "/usr/lib", "/lib64", "/usr/lib64", "/usr/local/lib"]
        .iter()
        .flat_map(|folder| [Path::new(folder).to_owned(), Path::new(folder).join(&architecture)])
        .chain(std::env::split_paths(&loader))
        .any(|folder| folder.join(name).exists())
}
