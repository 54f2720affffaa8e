//! Graphics processors in the sandbox.
//!
//! A driver in the system's core is a large thing to show to strangers, so devices are let in for
//! a lab that needs them and for no other. Where there is none, Vulkan is made of software, and
//! needs nothing but the system's libraries.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use lab_kit::{Kit, Lab, Workers, files_below};

/// How names in `/dev` begin: of Mesa's devices, of NVIDIA's, and of those of Windows' subsystem.
const NAMES: [&str; 3] = ["dri", "nvidia", "dxg"];

/// Where drivers look for what they drive, and for their settings.
const SETTINGS: [&str; 3] = ["/sys", "/etc/nvidia", "/etc/drirc"];

/// What the instructor has said about the choice of a driver and a device.
const CHOICE: [&str; 3] = ["WGPU_ADAPTER_NAME", "VK_DRIVER_FILES", "VK_ICD_FILENAMES"];

/// The devices of this machine that a lab's programs may use.
#[derive(Debug, Default)]
pub(crate) struct Devices {
    /// Files and folders in `/dev`.
    paths: Vec<PathBuf>,
    /// Groups that may open them where not everybody may.
    groups: BTreeSet<u32>,
    choice: Vec<(&'static str, OsString)>,
}

impl Devices {
    /// What a lab may use.
    pub(crate) fn of(kit: &Kit, lab: Lab) -> Result<Self> {
        if kit.facts(lab)?.workers != Workers::Device {
            return Ok(Self::default());
        }
        let set = |name| Some((name, std::env::var_os(name)?));
        let choice = CHOICE.into_iter().filter_map(set).collect();
        Ok(Self { choice, ..Self::below(Path::new("/dev"))? })
    }

    fn below(folder: &Path) -> Result<Self> {
        let is_one = |name: &str| NAMES.iter().any(|known| name.starts_with(known));
        let mut found = Self::default();
        for entry in fs::read_dir(folder)?.flatten() {
            if is_one(&entry.file_name().to_string_lossy()) {
                found.paths.push(entry.path());
            }
        }
        found.paths.sort();
        for path in &found.paths {
            let files = if path.is_dir() { files_below(path)? } else { vec![path.clone()] };
            for about in files.iter().filter_map(|file| fs::metadata(file).ok()) {
                let (group, all) = (0o060, 0o006);
                if about.mode() & group == group && about.mode() & all != all {
                    found.groups.insert(about.gid());
                }
            }
        }
        Ok(found)
    }

    /// Whether there is any.
    pub(crate) fn any(&self) -> bool {
        !self.paths.is_empty()
    }

    /// The groups that a program needs, as setpriv takes them.
    pub(crate) fn groups(&self) -> Vec<String> {
        if self.groups.is_empty() {
            return vec!["--clear-groups".into()];
        }
        let groups: Vec<String> = self.groups.iter().map(u32::to_string).collect();
        vec!["--groups".into(), groups.join(",")]
    }

    /// Tells bubblewrap to let them in.
    pub(crate) fn let_in(&self, command: &mut Command) {
        for path in &self.paths {
            command.arg("--dev-bind-try").arg(path).arg(path);
        }
        for path in SETTINGS.iter().filter(|_| self.any()) {
            command.args(["--ro-bind-try", path, path]);
        }
        for (name, value) in &self.choice {
            command.args(["--setenv", name]).arg(value);
            for file in std::env::split_paths(value).filter(|file| file.is_absolute()) {
                command.arg("--ro-bind-try").arg(&file).arg(file);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::os::unix::fs::{MetadataExt, PermissionsExt};
    use std::process::Command;

    use super::Devices;
    use lab_kit::Kit;

    #[test]
    fn devices_and_who_may_open_them() {
        let dev = tempfile::tempdir().unwrap();
        let file = |name: &str, mode| {
            let path = dev.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, "").unwrap();
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            path
        };
        file("nvidia0", 0o666);
        file("sda", 0o660);
        let found = Devices::below(dev.path()).unwrap();
        assert_eq!(found.paths, [dev.path().join("nvidia0")], "a disk is none");
        assert_eq!(found.groups(), ["--clear-groups"], "everybody may open it");

        let node = file("dri/renderD128", 0o660);
        let found = Devices::below(dev.path()).unwrap();
        assert_eq!(found.paths, [dev.path().join("dri"), dev.path().join("nvidia0")]);
        let group = fs::metadata(node).unwrap().gid().to_string();
        assert_eq!(found.groups(), ["--groups", &group]);

        let mut command = Command::new("bwrap");
        found.let_in(&mut command);
        let told: Vec<_> = command.get_args().map(|arg| arg.to_string_lossy()).collect();
        let dri = dev.path().join("dri").display().to_string();
        assert!(told.windows(3).any(|three| three == ["--dev-bind-try", &dri, &dri]), "{told:?}");
    }

    #[test]
    fn only_a_lab_with_kernels_gets_any() {
        let kit = Kit::find().unwrap();
        let mut command = Command::new("bwrap");
        Devices::of(&kit, "2".parse().unwrap()).unwrap().let_in(&mut command);
        assert_eq!(command.get_args().count(), 0);
    }
}
