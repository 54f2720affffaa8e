//! What a lab needs of the system beyond Rust.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use toml_edit::DocumentMut;

use crate::kit::{Kit, Lab};

/// What to install before the lab can run; none if all is there. The lab's dependencies tell.
pub(crate) fn missing(kit: &Kit, lab: Lab) -> Result<Option<&'static str>> {
    let solution = kit.solution(lab).join("Cargo.toml");
    let manifest = if solution.is_file() { solution } else { kit.starter(lab).join("Cargo.toml") };
    let unread = || format!("cannot read {}", manifest.display());
    let manifest: DocumentMut =
        fs::read_to_string(&manifest).with_context(unread)?.parse().with_context(unread)?;
    let depends_on =
        |name: &str| manifest.get("dependencies").is_some_and(|d| d.get(name).is_some());
    if depends_on("mpi") && !(on_path("mpicc") && on_path("mpirun")) {
        return Ok(Some(
            "an MPI library: on Debian and Ubuntu 'apt install libopenmpi-dev openmpi-bin libclang-dev'",
        ));
    }
    if (depends_on("wgpu") || depends_on("ash"))
        && cfg!(target_os = "linux")
        && !has_library("libvulkan.so.1")
    {
        return Ok(Some(
            "a Vulkan driver: on Debian and Ubuntu 'apt install libvulkan1 mesa-vulkan-drivers'",
        ));
    }
    Ok(None)
}

fn on_path(program: &str) -> bool {
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
