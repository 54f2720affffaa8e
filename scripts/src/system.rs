//! What a lab needs of the system beyond Rust.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use oracle::mpiexec::Launcher;
use toml_edit::{DocumentMut, Item};

use crate::kit::{Kit, Lab};

/// Whether the lab's program runs on ranks of MPI.
pub(crate) fn has_ranks(kit: &Kit, lab: Lab) -> Result<bool> {
    Ok(dependencies(kit, lab)?.contains("mpi"))
}

/// Whether the lab's program runs kernels on a graphics processor.
pub(crate) fn has_kernels(kit: &Kit, lab: Lab) -> Result<bool> {
    let dependencies = dependencies(kit, lab)?;
    Ok(["wgpu", "ash"].iter().any(|driver| dependencies.contains(*driver)))
}

/// What to install before the lab can run; none if all is there. The lab's dependencies tell.
pub(crate) fn missing(kit: &Kit, lab: Lab) -> Result<Option<&'static str>> {
    let dependencies = dependencies(kit, lab)?;
    let depends_on = |name: &str| dependencies.contains(name);
    if depends_on("mpi") && !has_mpi() {
        return Ok(Some(
            "an MPI library: on Debian and Ubuntu 'apt install libopenmpi-dev openmpi-bin libclang-dev'",
        ));
    }
    if has_kernels(kit, lab)? && cfg!(target_os = "linux") && !has_library("libvulkan.so.1") {
        return Ok(Some(
            "a Vulkan driver: on Debian and Ubuntu 'apt install libvulkan1 mesa-vulkan-drivers'",
        ));
    }
    Ok(None)
}

/// The names of what the lab depends on.
fn dependencies(kit: &Kit, lab: Lab) -> Result<BTreeSet<String>> {
    let solution = kit.solution(lab).join("Cargo.toml");
    let path = if solution.is_file() { solution } else { kit.starter(lab).join("Cargo.toml") };
    let unread = || format!("cannot read {}", path.display());
    let manifest = fs::read_to_string(&path).with_context(unread)?;
    let manifest: DocumentMut = manifest.parse().with_context(unread)?;
    let table = manifest.get("dependencies").and_then(Item::as_table_like);
    Ok(table.into_iter().flat_map(|table| table.iter()).map(|(name, _)| name.to_owned()).collect())
}

/// A compiler for MPI and a launcher, where the build and the tests look for them.
fn has_mpi() -> bool {
    let compiler = std::env::var_os("MPICC").unwrap_or_else(|| "mpicc".into());
    (on_path(&compiler) || Path::new(&compiler).is_file()) && Launcher::find().is_ok()
}

/// Whether there is such a program.
pub(crate) fn on_path(program: &OsStr) -> bool {
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
