//! `cargo lab --version`: prints the versions that a bug report needs.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use lab_kit::Kit;
use lab_kit::machine::machine;

/// Folders of Vulkan drivers on Linux.
const DRIVERS: [&str; 2] = ["/usr/share/vulkan/icd.d", "/etc/vulkan/icd.d"];

/// Returns the versions of the kit, the compiler, and the software that some labs need.
pub(crate) fn version(kit: &Kit) -> String {
    let mut git = Command::new("git");
    git.arg("-C").arg(kit.root()).args(["log", "-1", "--format= (%h, %cs)"]);
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").current_dir(kit.root());
    let mut mpiexec = Command::new(env::var_os("MPIEXEC").unwrap_or_else(|| "mpiexec".into()));
    let drivers: Vec<String> = DRIVERS.iter().flat_map(|folder| names(Path::new(folder))).collect();
    format!(
        "cutoff {}{}\n{}\nMPI      {}\nVulkan   {}\nmachine  {}\n",
        env!("CARGO_PKG_VERSION"),
        first_line(&mut git).unwrap_or_default(),
        first_line(&mut rustc).unwrap_or_else(|| "no rustc".into()),
        first_line(mpiexec.arg("--version")).unwrap_or_else(|| "no mpiexec".into()),
        if drivers.is_empty() { "no driver found".into() } else { drivers.join(", ") },
        machine(),
    )
}

/// Returns the first line that a program prints; `None` if it fails or prints nothing.
fn first_line(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    String::from_utf8_lossy(&output.stdout).lines().next().map(str::to_owned)
}

/// Returns the names of drivers in a folder, such as `lvp_icd.x86_64`, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .filter_map(|entry| Some(entry.path().file_stem()?.to_string_lossy().into_owned()))
        .collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::version;
    use lab_kit::Kit;

    #[test]
    fn it_names_kit_compiler_and_machine() {
        let version = version(&Kit::find().unwrap());
        let lines: Vec<&str> = version.lines().collect();
        assert!(lines[0].starts_with(concat!("cutoff ", env!("CARGO_PKG_VERSION"))), "{version}");
        assert!(lines[1].starts_with("rustc 1."), "{version}");
        let names: Vec<&str> =
            lines[2..].iter().filter_map(|line| line.split(' ').next()).collect();
        assert_eq!(names, ["MPI", "Vulkan", "machine"]);
    }
}
