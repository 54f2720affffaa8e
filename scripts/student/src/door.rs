//! Runs commands of other packages, which are found by name and built when they are called.

use std::ffi::{OsStr, OsString};
use std::os::unix::process::CommandExt;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, ensure};
use clap::Subcommand;
use lab_kit::cargo::run_visibly;
use lab_kit::command::{Family, command_line, families};
use lab_kit::{Kit, fresh};

/// Runs a command of a different package in place of this process, if the command line names one.
pub(crate) fn elsewhere(kit: &Kit) -> Result<Option<ExitCode>> {
    let mut arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    // `cargo lab help race` becomes `cargo lab race --help`.
    if arguments.len() == 2 && arguments[0] == "help" {
        arguments = vec![arguments.remove(1), "--help".into()];
    }
    let Some(name) = arguments.first() else { return Ok(None) };
    let Some(family) = family_of(kit, name)? else { return Ok(None) };
    let mut command = built(kit, &family)?;
    Err(command.args(arguments).exec()).context("cargo did not start")
}

/// Runs a command of a different package, such as `speed 10`, to its end.
///
/// # Errors
/// If there is no such command, or if it does not build or start.
pub(crate) fn pass(kit: &Kit, words: &[&str]) -> Result<()> {
    let family = family_of(kit, words[0].as_ref())?;
    let family = family.with_context(|| format!("no command {}", words[0]))?;
    built(kit, &family)?.args(words).status().context("cargo did not start")?;
    Ok(())
}

/// Finds the other package that has a command; `None` if there is none.
fn family_of(kit: &Kit, name: &OsStr) -> Result<Option<Family>> {
    let mut others = others(families(kit)?).into_iter();
    Ok(others.find(|family| family.commands.iter().any(|(own, _)| name == own.as_str())))
}

/// Builds a package, and returns the beginning of a command line that runs it.
fn built(kit: &Kit, family: &Family) -> Result<Command> {
    let mut build = cargo(kit, family, "build");
    build.arg("--message-format=json-render-diagnostics").current_dir(kit.root());
    let built = fresh::build(&mut build, run_visibly).context("cargo did not start")?;
    ensure!(built.status.success(), "{} does not build, see above", family.package);
    let mut command = cargo(kit, family, "run");
    command.args(["--quiet", "--"]);
    Ok(command)
}

/// Returns the beginning of a Cargo command about a package, in the current folder.
fn cargo(kit: &Kit, family: &Family, verb: &str) -> Command {
    let mut command = Command::new(kit.cargo().get_program());
    command.arg(verb).arg("--manifest-path").arg(kit.path("Cargo.toml"));
    command.args(["--package", &family.package]);
    command.args((!cfg!(debug_assertions)).then_some("--release"));
    command
}

/// Returns the command line of this package, which also contains the names of all other commands.
///
/// So the help lists them, and a mistyped name gets a suggestion.
pub(crate) fn command<C: Subcommand>(kit: &Kit) -> Result<clap::Command> {
    let families = families(kit)?;
    let mut command = command_line::<C>();
    let about = command.get_about().map(ToString::to_string).unwrap_or_default();
    let help = format!("{about}\n\nUsage: cargo lab <COMMAND>\n{}", listed(&families));
    for (name, about) in others(families).into_iter().flat_map(|family| family.commands) {
        command = command.subcommand(clap::Command::new(name).about(about));
    }
    Ok(command.override_help(help))
}

fn others(mut families: Vec<Family>) -> Vec<Family> {
    families.retain(|family| family.package != env!("CARGO_PKG_NAME"));
    families
}

/// Lists all commands, below a heading for each package.
fn listed(families: &[Family]) -> String {
    let names = families.iter().flat_map(|family| &family.commands).map(|(name, _)| name.len());
    let width = names.max().unwrap_or(0);
    let mut out = String::new();
    for Family { title, commands, .. } in families.iter().filter(|f| !f.commands.is_empty()) {
        out += &format!("\n{title}:\n");
        for (name, about) in commands {
            out += &format!("  {name:width$}  {about}\n");
        }
    }
    out + "\n'cargo lab COMMAND --help' explains a command, and 'cargo lab --version' lists what is installed.\n"
}
