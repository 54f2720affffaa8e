//! What builds in the sandbox need of the user's own settings of cargo: how to reach the registry.
//!
//! The rest is for the user's own work. A wrapper of the compiler that is not there, another target or build folder would
//! keep everybody from being graded.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use toml_edit::{DocumentMut, Item, value};

/// The tables that say where sources of dependencies come from.
const KEPT: [&str; 3] = ["source", "registries", "registry"];

/// A source may be a folder of the machine.
const FOLDERS: [&str; 2] = ["directory", "local-registry"];

/// Variables of cargo and the compiler that change a build. Their names begin so.
const CHANGING: [&str; 6] = [
    "CARGO_BUILD_",
    "CARGO_TARGET_",
    "CARGO_PROFILE_",
    "CARGO_ENCODED_",
    "CARGO_UNSTABLE_",
    "RUST",
];

/// Cargo's folder with nothing else in it.
#[derive(Debug)]
pub(super) struct Registry {
    /// The folder.
    pub(super) home: PathBuf,
    /// Folders of the machine that the settings name.
    pub(super) folders: Vec<PathBuf>,
}

impl Registry {
    /// Makes it in `scratch` from the user's own.
    pub(super) fn of(cargo_home: &Path, scratch: &Path) -> Result<Self> {
        let home = scratch.join("cargo");
        let make = || -> Result<Vec<PathBuf>> {
            fs::create_dir_all(&home)?;
            for part in ["registry", "git"] {
                symlink(cargo_home.join(part), home.join(part))?;
            }
            // Cargo reads the name without an ending first.
            let files = ["config", "config.toml"].map(|name| cargo_home.join(name));
            let text = files.iter().find_map(|file| fs::read_to_string(file).ok());
            let (text, folders) = reduced(&text.unwrap_or_default(), cargo_home)?;
            fs::write(home.join("config.toml"), text)?;
            Ok(folders)
        };
        let unmade = || format!("cannot take over the settings of {}", cargo_home.display());
        let folders = make().with_context(unmade)?;
        Ok(Self { home, folders })
    }

    /// Lets cargo see nothing else, where there is no sandbox.
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

/// Settings without what is not of the registry, and the folders that they name.
fn reduced(text: &str, cargo_home: &Path) -> Result<(String, Vec<PathBuf>)> {
    let mut settings: DocumentMut = text.trim_start_matches('\u{feff}').parse()?;
    settings.retain(|name, _| KEPT.contains(&name));
    let mut folders = Vec::new();
    let sources = settings.get_mut("source").and_then(Item::as_table_like_mut);
    for (_, source) in sources.into_iter().flat_map(|sources| sources.iter_mut()) {
        for key in FOLDERS {
            let Some(path) = source.get(key).and_then(Item::as_str) else { continue };
            // A path is below the folder that has cargo's own in it.
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
