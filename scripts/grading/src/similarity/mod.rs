//! `cargo lab similarity`: who wrote the same?
//!
//! Names, numbers, comments and layout are put aside ([`tokens`]), what the starter has does not
//! count, and what is left is compared by fingerprints ([`prints`], [`pairs`]). The table says
//! where to look; whether two students talked too much, a reader decides.

mod pairs;
mod prints;
mod tokens;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail, ensure};
use clap::Args;

use self::pairs::{Pair, Suspect};
use crate::intake;
use lab_kit::starter;
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab};

/// Of a pair, so many passages are shown.
const SHOWN: usize = 5;

/// Compare the submissions of a class with one another (for instructors)
///
/// Renamed variables, other comments, another layout and functions in another order make no
/// difference, and the starter's own code does not count. The two shares say how much of each
/// student's own tokens the other has too. Either may be the copy, or both of a third: that the
/// shares do not say.
#[derive(Args)]
pub(crate) struct Options {
    /// A folder with a submission in each folder or .tar.gz
    folder: PathBuf,
    /// The lab [default: the only one that was handed in]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Show pairs that share at least so much
    #[arg(long, default_value_t = 40.0, value_name = "PERCENT")]
    from: f64,
    /// Print all pairs as JSON
    #[arg(long)]
    json: bool,
}

/// Compares all pairs and prints those that share much.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut submissions = read(&options.folder)?;
    let lab = match options.lab {
        Some(lab) => lab,
        None => only_lab(&submissions)?,
    };
    let starter: Sources = starter::generate(kit, lab)?
        .into_iter()
        .filter_map(|(path, bytes)| Some((path.to_str()?.to_owned(), bytes)))
        .collect();
    let given = pairs::starter(&starter);
    let mut cohort = Vec::new();
    for (name, labs) in &mut submissions {
        if let Some(sources) = labs.remove(&lab) {
            let number = cohort.len() as u32;
            cohort.push(Suspect::new(name.clone(), number, &sources, &given));
        }
    }
    ensure!(cohort.len() > 1, "fewer than two submissions have a lab {lab}");
    let mut pairs = pairs::pairs(&cohort);
    if options.json {
        println!("{}", serde_json::to_string_pretty(&pairs)?);
        return Ok(ExitCode::SUCCESS);
    }
    let all = pairs.len();
    pairs.retain(|pair| 100.0 * pair.of_first.max(pair.of_second) >= options.from);
    println!(
        "Lab {lab}: {} submissions, {} of {all} pairs with something in common share {} % or more.",
        cohort.len(),
        pairs.len(),
        options.from
    );
    print!("{}", table(&pairs));
    Ok(ExitCode::SUCCESS)
}

/// The submissions in a folder, by name. One that cannot be read is named and passed over.
fn read(folder: &Path) -> Result<BTreeMap<String, BTreeMap<Lab, Sources>>> {
    let unread = || format!("cannot read {}", folder.display());
    let mut submissions = BTreeMap::new();
    for entry in fs::read_dir(folder).with_context(unread)? {
        let path = entry.with_context(unread)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match intake::read(&path) {
            Ok(handed_in) => {
                let labs = handed_in.labs.into_iter().map(|(lab, taken)| (lab, taken.files));
                submissions.insert(name, labs.filter(|(_, files)| !files.is_empty()).collect());
            }
            Err(error) => eprintln!("passed over: {error:#}"),
        }
    }
    Ok(submissions)
}

fn only_lab(submissions: &BTreeMap<String, BTreeMap<Lab, Sources>>) -> Result<Lab> {
    let labs: BTreeSet<Lab> = submissions.values().flat_map(BTreeMap::keys).copied().collect();
    match labs.iter().collect::<Vec<_>>()[..] {
        [lab] => Ok(*lab),
        [] => bail!("nothing there has labs/labN/src in it"),
        _ => bail!("several labs were handed in: say which with --lab N"),
    }
}

fn table(pairs: &[Pair]) -> String {
    let mut out = String::new();
    for pair in pairs {
        out += &format!(
            "\n{} ({:.0} %)  and  {} ({:.0} %)\n",
            pair.first,
            100.0 * pair.of_first,
            pair.second,
            100.0 * pair.of_second
        );
        for passage in pair.passages.iter().take(SHOWN) {
            let place = |(file, lines): &(String, std::ops::RangeInclusive<u32>)| {
                format!("{file}:{}-{}", lines.start(), lines.end())
            };
            let (first, second) = (place(&passage.first), place(&passage.second));
            out += &format!("  {:4} tokens  {first:32}  {second}\n", passage.tokens);
        }
        if pair.passages.len() > SHOWN {
            out += &format!("  and {} shorter passages\n", pair.passages.len() - SHOWN);
        }
    }
    out
}

#[cfg(test)]
mod tests;
