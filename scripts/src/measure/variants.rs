//! What a program can do: its variants and their parameters, in its own words.

use std::process::{Command, Stdio};

use anyhow::{Context, Result};
use oracle::mpiexec::Launcher;

use super::program::{Binaries, Program};

/// A variant that a program has told of.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Known {
    /// Its name.
    pub(crate) name: String,
    /// The names of its parameters.
    pub(crate) parameters: Vec<String>,
}

/// A program's variants, by its answer to `--list-variants`. One with ranks is asked on one rank.
pub(crate) fn variants(
    binaries: &Binaries,
    program: &Program,
    launcher: Option<&Launcher>,
) -> Result<Vec<Known>> {
    let mut command = match launcher {
        Some(launcher) if program.has_ranks() => launcher.start(1, binaries.of(program)?),
        _ => Command::new(binaries.of(program)?),
    };
    let output = command.arg("--list-variants").stdin(Stdio::null()).output();
    let output = output.with_context(|| format!("{} did not start", program.binary()))?;
    Ok(known(&String::from_utf8_lossy(&output.stdout)))
}

/// Reads a list of variants: a name starts its line, what can be set in a variant is indented.
pub(crate) fn known(text: &str) -> Vec<Known> {
    let mut all: Vec<Known> = Vec::new();
    for line in text.lines() {
        let parameter =
            line.trim_start().strip_prefix("--param ").and_then(|rest| rest.split_once('='));
        match (parameter, all.last_mut()) {
            (Some((name, _)), Some(variant)) => variant.parameters.push(name.to_owned()),
            _ => {
                let name = line.split(' ').next().filter(|name| !name.is_empty());
                all.extend(name.map(|name| Known { name: name.into(), parameters: Vec::new() }));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::known;

    #[test]
    fn variants_are_read_with_their_settings() {
        let text = "master-workers  a master\n                  --param keep=1 (0 to 1): x\ncells           y\n";
        let [master, cells] = &known(text)[..] else { panic!("two variants: {:?}", known(text)) };
        assert_eq!(
            (master.name.as_str(), &master.parameters[..]),
            ("master-workers", &["keep".into()][..])
        );
        assert_eq!((cells.name.as_str(), cells.parameters.len()), ("cells", 0));
    }
}
