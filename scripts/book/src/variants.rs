//! Tables of all variants. Their texts come from the labs' facts, and their times from the races in
//! book/data.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, Result};

use lab_kit::binaries::Known;
use lab_kit::facts::VariantFacts;
use lab_kit::program::Program;
use lab_kit::{Kit, Lab};

use crate::entries::Data;
use crate::plot::{Row, Time, plot};
use crate::query::Query;

/// The numbers of particles for soft and for hard discs.
const SIZES: [(&str, [&str; 3]); 2] =
    [("soft", ["1000", "10000", "100000"]), ("hard", ["1000", "4000", "16000"])];

/// Names of the races: `compare` for these tables, `apart` for variants whose rows show no times.
const RACES: [&str; 2] = ["compare", "apart"];

/// Returns the facts of all variants, lab by lab.
fn words(kit: &Kit) -> Result<Vec<(Lab, VariantFacts)>> {
    let mut words = Vec::new();
    for lab in kit.solutions() {
        words.extend(kit.facts(lab)?.variants.into_iter().map(|variant| (lab, variant)));
    }
    Ok(words)
}

/// Returns a plot and two tables of the variants of `soft` or `hard` discs, lab by lab: times and
/// texts.
pub(crate) fn table(data: &mut Data, discs: &str) -> Result<String> {
    let sizes = SIZES.iter().find(|(name, _)| *name == discs).context("discs are soft or hard")?.1;
    let [small, middle, large] = sizes;
    let mut times = format!(
        "\n| variant | lab | n = {small} | n = {middle} | n = {large} | two workers |\n\
         |---|---|---:|---:|---:|---:|\n"
    );
    let mut text = String::from(
        "\n| variant | error | more workers | memory | when to use it |\n|---|---|---|---|---|\n",
    );
    let mut rows = Vec::new();
    for (lab, VariantFacts { name, error, scaling, memory, when, .. }) in words(data.kit)? {
        if !is_timed(data, lab, &name, discs)? {
            continue;
        }
        let words = format!("compare-{discs}-*.json; lab={lab}; variant={name}; workers=1; ns.min");
        let query = Query::default().with(&words);
        times += &format!("| `{name}` | [{lab}](lab{lab}.md) |");
        let mut on_one = sizes.map(|n| Time { n, printed: None });
        for time in &mut on_one {
            let query = query.clone().with(&format!("n={}", time.n));
            time.printed = query.any_answer(data)?;
            times += &format!(" {} |", time.printed.as_deref().unwrap_or("–"));
        }
        let gain = query.with(&format!("n={large}; over workers=2; .2")).any_answer(data)?;
        times += &format!(" {} |\n", gain.unwrap_or("–".into()));
        text += &format!("| `{name}` | {error} | {scaling} | {memory} | {when} |\n");
        rows.push(Row { lab, name, workers: data.kit.facts(lab)?.workers, times: on_one });
    }
    Ok(plot(&rows) + &times + &text)
}

/// Whether a race of these discs has timed a variant.
fn is_timed(data: &mut Data, lab: Lab, variant: &str, discs: &str) -> Result<bool> {
    for race in RACES {
        let runs = data.entries(&format!("{race}-{discs}-*.json"))?;
        let lab = lab.to_string();
        if runs.iter().any(|run| run.has("lab", &lab) && run.has("variant", variant)) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Finds variants without a time, and variants that are only in the program or only in `lab.toml`.
///
/// Programs that are built in the folder `programs` list their variants.
///
/// # Errors
/// The facts or a race cannot be read, or a program lists no variants.
pub(crate) fn check(data: &mut Data, programs: &Path) -> Result<Vec<String>> {
    let words = words(data.kit)?;
    let mut wrong = Vec::new();
    for (lab, VariantFacts { name, .. }) in &words {
        if !is_timed(data, *lab, name, "soft")? && !is_timed(data, *lab, name, "hard")? {
            wrong.push(format!("lab {lab}, {name}: no race in book/data"));
        }
    }
    let mut unbuilt = Vec::new();
    for lab in data.kit.solutions() {
        // The contest's entry is compared in its own chapter.
        if !words.iter().any(|row| row.0 == lab) {
            continue;
        }
        let Some(there) = ask(lab, programs)? else {
            unbuilt.push(lab.to_string());
            continue;
        };
        let rows = words.iter().filter(|row| row.0 == lab).map(|row| row.1.name.clone()).collect();
        let differing = there.symmetric_difference(&rows);
        let fault = "either its program or lab.toml does not have it";
        wrong.extend(differing.map(|name| format!("lab {lab}, {name}: {fault}")));
    }
    if !unbuilt.is_empty() {
        println!("left out: variants of labs {}, whose programs are not built", unbuilt.join(", "));
    }
    Ok(wrong)
}

/// Returns the variants that the solution's programs list; `None` if a program is not built.
fn ask(lab: Lab, programs: &Path) -> Result<Option<BTreeSet<String>>> {
    let first = Program::new(lab, true)?;
    let mut there = BTreeSet::new();
    for program in first.others()?.iter().chain([&first]) {
        let file = programs.join(program.binary());
        if !file.is_file() {
            return Ok(None);
        }
        let mut list = Command::new(&file);
        let listed = list.args(["--list-variants", "--json"]).stderr(Stdio::null()).output()?;
        let known: Vec<Known> = serde_json::from_slice(&listed.stdout)
            .with_context(|| format!("{} lists no variants", file.display()))?;
        there.extend(known.into_iter().map(|known| known.name));
    }
    Ok(Some(there))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    use super::{check, table};
    use crate::entries::Data;
    use lab_kit::Kit;

    const SORTED: &str = "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[[variant]]\nname = 'sorted'\n\
        error = 'none'\nscaling = 'no'\nmemory = 'n'\nwhen = 'now'\n";
    const RACE: &str = r#"{"results": {"programs": [
        {"program": "solution2:sorted,t=1", "scene": {"soft": {"n": 100000}}, "ranks": null, "threads": 1,
         "nanoseconds_per_particle_and_step": {"min": 29.01}},
        {"program": "solution2:sorted,t=2", "scene": {"soft": {"n": 100000}}, "ranks": null, "threads": 2,
         "nanoseconds_per_particle_and_step": {"min": 20.0}}
    ]}}"#;

    /// Calls `test` with a kit that has a row and a race of lab 2's `sorted`, and a program with
    /// one variant.
    fn with(variant: &str, test: impl FnOnce(&Kit)) {
        let folder = tempfile::tempdir().unwrap();
        let list = format!("#!/bin/sh\necho '[{{\"name\": \"{variant}\", \"parameters\": []}}]'\n");
        let files = [
            ("solutions/lab2/Cargo.toml", ""),
            ("solutions/lab2/lab.toml", SORTED),
            ("book/data/compare-soft-1.json", RACE),
            ("book/data/lab2-race.json", "not looked at"),
            ("solution2", &list),
        ];
        let kit = Kit::of_files(folder.path(), &files);
        let executable = fs::Permissions::from_mode(0o755);
        fs::set_permissions(kit.path("solution2"), executable).unwrap();
        test(&kit);
    }

    #[test]
    fn words_and_times_meet_in_one_row() {
        with("sorted", |kit| {
            let table = table(&mut Data::new(kit), "soft").unwrap();
            let times = "| `sorted` | [2](lab2.md) | – | – | 29.0 | 1.45 |\n";
            assert!(table.contains(times), "{table}");
            assert!(table.contains("| `sorted` | none | no | n | now |\n"), "{table}");
            assert_eq!(check(&mut Data::new(kit), kit.root()).unwrap(), [""; 0]);
        });
    }

    #[test]
    fn a_row_needs_a_time_and_a_variant_and_a_variant_a_row() {
        with("other", |kit| {
            let faults = check(&mut Data::new(kit), kit.root()).unwrap();
            let names = faults.iter().map(|fault| fault.split(':').next().unwrap_or_default());
            assert_eq!(names.collect::<Vec<_>>(), ["lab 2, other", "lab 2, sorted"]);
            fs::remove_file(kit.path("book/data/compare-soft-1.json")).unwrap();
            let faults = check(&mut Data::new(kit), &kit.path("nothing is built here")).unwrap();
            assert_eq!(faults, ["lab 2, sorted: no race in book/data"]);
        });
    }
}
