//! Settings of the user's Cargo configuration with which builds in the sandbox reach the registry.
//!
//! The other settings concern only the user's own work. A missing compiler wrapper, or a different
//! target or build folder, would make every build fail.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use toml_edit::{DocumentMut, Item, value};

/// Tables of the configuration that name the sources of dependencies.
const KEPT: [&str; 3] = ["source", "registries", "registry"];

/// Keys whose value is a folder of the machine.
const FOLDERS: [&str; 2] = ["directory", "local-registry"];

/// Beginnings of the names of environment variables that change a build.
const CHANGING: [&str; 6] = [
    "CARGO_BUILD_",
    "CARGO_TARGET_",
    "CARGO_PROFILE_",
    "CARGO_ENCODED_",
    "CARGO_UNSTABLE_",
    "RUST",
];

/// A Cargo home folder with only the settings of the registry.
#[derive(Debug)]
pub(super) struct Registry {
    /// Path of the folder.
    pub(super) home: PathBuf,
    /// Folders of the machine that the settings name.
    pub(super) folders: Vec<PathBuf>,
}

impl Registry {
    /// Makes the folder in `scratch` from the user's own `cargo_home`.
    pub(super) fn of(cargo_home: &Path, scratch: &Path) -> Result<Self> {
        Self::make(cargo_home, scratch.join("cargo"))
            .with_context(|| format!("cannot take over the settings of {}", cargo_home.display()))
    }

    fn make(cargo_home: &Path, home: PathBuf) -> Result<Self> {
        fs::create_dir_all(&home)?;
        for part in ["registry", "git"] {
            symlink(cargo_home.join(part), home.join(part))?;
        }
        // Cargo prefers the name without an extension.
        let files = ["config", "config.toml"].map(|name| cargo_home.join(name));
        let text = files.iter().find_map(|file| fs::read_to_string(file).ok());
        let (text, folders) = reduced(&text.unwrap_or_default(), cargo_home)?;
        fs::write(home.join("config.toml"), text)?;
        Ok(Self { home, folders })
    }

    /// Makes a Cargo command outside a sandbox use only these settings.
    pub(super) fn set(&self, cargo: &mut Command) {
        for (name, _) in std::env::vars_os() {
            let shown = name.to_string_lossy();
            let is_of_rustup = shown.starts_with("RUSTUP_");
            if !is_of_rustup && CHANGING.iter().any(|begin| shown.starts_with(begin)) {
                cargo.env_remove(name);
            }
        }
        cargo.env("CARGO_HOME", &self.home);
    }
}

/// Returns the settings of the registry only, and the folders that they name.
fn reduced(text: &str, cargo_home: &Path) -> Result<(String, Vec<PathBuf>)> {
    let mut settings: DocumentMut = text.trim_start_matches('\u{feff}').parse()?;
    settings.retain(|name, _| KEPT.contains(&name));
    let mut folders = Vec::new();
    let sources = settings.get_mut("source").and_then(Item::as_table_like_mut);
    for (_, source) in sources.into_iter().flat_map(|sources| sources.iter_mut()) {
        for key in FOLDERS {
            let Some(path) = source.get(key).and_then(Item::as_str) else { continue };
            // Cargo resolves a relative path from the parent of its home folder.
            let folder = cargo_home.parent().unwrap_or(cargo_home).join(path);
            source[key] = value(folder.display().to_string());
            folders.push(folder);
        }
    }
    Ok((settings.to_string(), folders))
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::reduced;

    #[test]
    fn only_the_way_to_the_registry_is_kept() {
        let own = "\
paths = [\"/somewhere\"]

[build]
rustc-wrapper = \"sccache\"
target = \"wasm32-unknown-unknown\"
build-dir = \"/elsewhere\"
rustflags = [\"-Ctarget-cpu=native\"]

[source.crates-io]
replace-with = \"mirror\"

[source.mirror]
registry = \"sparse+https://mirror.example/\"

[target.x86_64-unknown-linux-gnu]
linker = \"mold\"

[env]
CC = \"none\"

[registries.own]
index = \"sparse+https://own.example/\"

[unstable]
gc = true
";
        let (kept, folders) = reduced(own, Path::new("/home/ada/.cargo")).unwrap();
        let lines: Vec<&str> = kept.lines().filter(|line| !line.is_empty()).collect();
        let expected = [
            "[source.crates-io]",
            "replace-with = \"mirror\"",
            "[source.mirror]",
            "registry = \"sparse+https://mirror.example/\"",
            "[registries.own]",
            "index = \"sparse+https://own.example/\"",
        ];
        assert_eq!((&lines[..], folders), (&expected[..], vec![]));
    }

    #[test]
    fn a_folder_of_sources_is_found_from_anywhere() {
        let own = "source.crates-io.replace-with = \"v\"\nsource.v.directory = \"vendor\"\nbuild.jobs = 1\n";
        let (kept, folders) = reduced(own, Path::new("/home/ada/.cargo")).unwrap();
        assert!(
            kept.contains("directory = \"/home/ada/vendor\"") && !kept.contains("jobs"),
            "{kept}"
        );
        assert_eq!(folders, [PathBuf::from("/home/ada/vendor")]);
        assert_eq!(reduced("", Path::new("/home/ada/.cargo")).unwrap(), (String::new(), vec![]));
    }
}
