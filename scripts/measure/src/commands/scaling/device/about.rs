//! The device that lab 9 runs on, in its own words.

use std::fmt;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize, Serializer};

use crate::runner::Runner;
use lab_kit::Kit;

/// A device.
#[derive(Deserialize, Serialize)]
pub(super) struct Device {
    /// Its name; that of software says that it is no GPU.
    pub(super) name: String,
    /// Whether it is a program on the host's processor, which must not be taken for a GPU.
    pub(super) software: bool,
    /// Whether it can time its kernels.
    pub(super) timestamps: bool,
    #[serde(serialize_with = "as_map", skip_deserializing)]
    about: Vec<(String, String)>,
}

impl Device {
    /// Asks the program `device`.
    ///
    /// # Errors
    /// There is no device: its words say so.
    pub(super) fn ask(kit: &Kit, runner: &Runner) -> Result<Self> {
        let mut cargo = kit.cargo();
        cargo.args(["run", "--release", "--quiet", "--package", "device"]);
        let text = runner.words(&mut cargo, "device")?;
        Self::read(&text).context("the program 'device' names no device")
    }

    fn read(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        let name = lines.next().filter(|name| !name.is_empty())?.to_owned();
        let pair = |line: &str| {
            let (what, value) = line.trim().split_once("  ")?;
            Some((what.to_owned(), value.trim().to_owned()))
        };
        let about: Vec<_> = lines.filter_map(pair).collect();
        let value = |what: &str| about.iter().find(|(w, _)| w == what).map(|(_, v)| v.as_str());
        let software = value("kind")?.contains("software");
        let timestamps = value("timestamps") == Some("yes");
        Some(Self { name, software, timestamps, about })
    }
}

fn as_map<S: Serializer>(about: &[(String, String)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(about.iter().map(|(what, value)| (what, value)))
}

impl fmt::Display for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "Device: {}", self.name)?;
        let width = self.about.iter().map(|(what, _)| what.len()).max().unwrap_or(0);
        self.about.iter().try_for_each(|(what, value)| writeln!(f, "  {what:width$}  {value}"))
    }
}

#[cfg(test)]
mod tests {
    use super::Device;

    #[test]
    fn software_is_no_gpu() {
        let text = "llvmpipe (LLVM 15, 256 bits) (software on the host's processor, not a GPU)\n  \
                    kind              software on the host's processor, not a GPU\n  \
                    double precision  yes\n  timestamps        yes\n";
        let device = Device::read(text).unwrap();
        assert!(device.software && device.timestamps);
        assert_eq!(device.about[1].0, "double precision");
        assert!(Device::read("").is_none());
    }
}
