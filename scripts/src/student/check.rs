//! `cargo lab check`: is it ready to be handed in?

use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use crate::kit::{Kit, Lab};
use crate::system;

/// Check a lab before you hand it in: format, lints, its tests and those of the labs before
#[derive(Args)]
pub(crate) struct Options {
    /// The lab
    lab: Lab,
    /// Leave out the tests of earlier labs
    #[arg(long)]
    only: bool,
}

/// Runs every check, also after one has failed, and says which passed.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    kit.expect_starter(lab)?;
    let package = format!("lab{lab}");
    let mut checks = vec![
        (
            format!("lab {lab} is formatted (cargo fmt -p {package})"),
            vec!["fmt".to_owned(), "-p".into(), package.clone(), "--check".into()],
        ),
        (
            format!("lab {lab} has no warnings, nothing unused"),
            ["clippy", "--quiet", "-p", &package, "--", "-D", "warnings", "-D", "unused"]
                .map(str::to_owned)
                .to_vec(),
        ),
    ];
    for other in kit.starters()? {
        let earlier = !options.only && other < lab && system::missing(kit, other)?.is_none();
        if other == lab || earlier {
            let test = ["test", "--quiet", "-p", &format!("lab{other}")].map(str::to_owned);
            checks.push((format!("the tests of lab {other} pass"), test.to_vec()));
        }
    }
    let mut failed = 0;
    for (what, arguments) in &checks {
        let output = kit.cargo().args(arguments).output().context("cannot run cargo")?;
        let passes = output.status.success();
        println!("{}  {what}", if passes { "passes" } else { "FAILS " });
        if !passes {
            failed += 1;
            let text = [output.stdout, output.stderr].concat();
            let text = String::from_utf8_lossy(&text);
            for line in text.lines().filter(|line| !line.trim().is_empty()).take(12) {
                println!("        {line}");
            }
        }
    }
    println!("{} passed, {failed} failed", checks.len() - failed);
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
