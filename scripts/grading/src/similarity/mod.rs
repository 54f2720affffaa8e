//! `cargo lab similarity`: who wrote the same?
//!
//! Names, numbers, comments and layout are put aside ([`tokens`]), what the starter has does not
//! count, and what is left is compared by fingerprints ([`prints`], [`pairs`]). The table says
//! where to look; whether two students talked too much, a reader decides.

mod page;
mod pairs;
mod prints;
mod tokens;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Result, bail, ensure};
use clap::Args;

use self::pairs::{Pair, Starter, Suspect};
use crate::escape::line;
use crate::intake;
use crate::intake::names::named;
use lab_kit::files::write_file;
use lab_kit::starter;
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab};

/// Of a pair, so many passages are shown.
const SHOWN: usize = 5;

/// The sources of each lab, by a submission's name.
type Submissions = BTreeMap<String, BTreeMap<Lab, Sources>>;

/// Compare the submissions of a class with one another (for instructors)
///
/// Renamed variables, other comments, another layout and functions in another order make no
/// difference, and the starter's own code does not count. The two shares say how much of each
/// student's own tokens the other has too. Either may be the copy, or both of a third: that the
/// shares do not say. Files that are equal to the byte are always named.
#[derive(Args)]
pub(crate) struct Options {
    /// A folder with a submission in each folder or archive
    folder: PathBuf,
    /// The lab [default: the only one that was handed in]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
    /// Compare with this class too, of last year for example
    #[arg(long, value_name = "FOLDER")]
    before: Vec<PathBuf>,
    /// Show pairs that share at least so much
    #[arg(long, default_value_t = 40.0, value_name = "PERCENT")]
    from: f64,
    /// Write a page with the passages side by side
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
    /// Print all pairs as JSON
    #[arg(long)]
    json: bool,
}

/// Compares all pairs and shows those that share much.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let submissions = read(kit, &options.folder)?;
    let lab = match options.lab {
        Some(lab) => lab,
        None => only_lab(&submissions)?,
    };
    let given: Sources = starter::generate(kit, lab)?
        .into_iter()
        .filter_map(|(path, bytes)| Some((path.to_str()?.to_owned(), bytes)))
        .collect();
    let given = Starter::new(&given);
    let mut cohort = Vec::new();
    let mut join = |submissions: Submissions, before: Option<&Path>| {
        for (name, mut labs) in submissions {
            let Some(sources) = labs.remove(&lab) else { continue };
            let name = before.map_or(name.clone(), |before| format!("{}/{name}", before.display()));
            let mut suspect = Suspect::new(name, cohort.len() as u32, &sources, &given);
            suspect.before = before.is_some();
            cohort.push(suspect);
        }
    };
    join(submissions, None);
    for folder in &options.before {
        join(read(kit, folder)?, Some(folder));
    }
    ensure!(cohort.len() > 1, "fewer than two submissions have a lab {lab}");
    let mut pairs = pairs::pairs(&cohort);
    if options.json {
        println!("{}", serde_json::to_string_pretty(&pairs)?);
        return Ok(ExitCode::SUCCESS);
    }
    let all = pairs.len();
    pairs.retain(|pair| 100.0 * pair.of_first.max(pair.of_second) >= options.from);
    let equal = pairs::equal(&cohort, &given);
    println!(
        "Lab {lab}: {} submissions, {} of {all} pairs with something in common share {} % or more.",
        cohort.len(),
        pairs.len(),
        options.from
    );
    for (names, files) in &equal {
        println!("Equal to the byte: {} of {}", line(&files.join(", ")), line(&names.join(", ")));
    }
    match options.page {
        Some(path) => {
            let title = format!("Lab {lab}: who wrote the same?");
            write_file(&path, page::page(&title, &cohort, &pairs, &equal))?;
            println!("The page: {}", path.display());
        }
        None => print!("{}", table(&pairs)),
    }
    Ok(ExitCode::SUCCESS)
}

/// The submissions in a folder, by name. One that cannot be read is named and passed over.
fn read(kit: &Kit, folder: &Path) -> Result<Submissions> {
    let mut submissions = Submissions::new();
    for (name, path) in named(intake::submissions(kit, folder)?) {
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

fn only_lab(submissions: &Submissions) -> Result<Lab> {
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
