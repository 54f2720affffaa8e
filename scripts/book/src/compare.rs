//! Every variant of every lab side by side: words from the facts of the labs, times from the races in book/data.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use serde_json::Value;

use lab_kit::facts::VariantFacts;
use lab_kit::files::{files_below, read_text};
use lab_kit::program::Program;
use lab_kit::table::three_digits;
use lab_kit::{Kit, Lab};

/// Races for these tables: `compare-soft-1000.json`.
const RACES: &str = "compare-";

/// Races of other sittings, whose variants have a row and no times: `apart-soft-lists-1000.json`.
const APART: &str = "apart-";

/// The least times of a variant in nanoseconds per particle and step, by n and workers.
type Least = BTreeMap<(usize, usize), f64>;

/// The least times of such races of soft or of hard discs, by lab and variant.
fn races(kit: &Kit, named: &str, discs: &str) -> Result<BTreeMap<(Lab, String), Least>> {
    let mut times: BTreeMap<_, Least> = BTreeMap::new();
    for path in files_below(&kit.path("book/data"))? {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if !(name.starts_with(named) && name.ends_with(".json")) {
            continue;
        }
        let no_race = || format!("{} is no race of variants of solutions", path.display());
        let race: Value = serde_json::from_str(&read_text(&path)?).with_context(no_race)?;
        for run in race["results"]["programs"].as_array().with_context(no_race)? {
            if run["scene"].get(discs).is_none() {
                continue;
            }
            let number = |value: &Value| value.as_u64().map(|number| number as usize);
            let time = || {
                let n = number(&run["scene"][discs]["n"])?;
                let workers = number(&run["ranks"]).unwrap_or(1) * number(&run["threads"])?;
                let nanoseconds = run["nanoseconds_per_particle_and_step"]["min"].as_f64()?;
                let program: Program = run["program"].as_str()?.parse().ok()?;
                let of = program.solution.then_some((program.lab, program.variant?))?;
                Some((of, (n, workers), nanoseconds))
            };
            let (name, at, nanoseconds) = time().with_context(no_race)?;
            let least = times.entry(name).or_default().entry(at).or_insert(f64::INFINITY);
            *least = least.min(nanoseconds);
        }
    }
    Ok(times)
}

/// What the labs say of their variants, lab by lab.
fn words(kit: &Kit) -> Result<Vec<(Lab, VariantFacts)>> {
    let mut words = Vec::new();
    for lab in kit.solutions() {
        words.extend(kit.facts(lab)?.variants.into_iter().map(|variant| (lab, variant)));
    }
    Ok(words)
}

/// The variants of `soft` or `hard` discs that the races timed, lab by lab: a table of times, and one of
/// words.
///
/// # Errors
/// The words or a race cannot be read, or there is no race of such discs.
pub(crate) fn table(kit: &Kit, discs: &str) -> Result<String> {
    let (apart, races) = (races(kit, APART, discs)?, races(kit, RACES, discs)?);
    let sizes: BTreeSet<usize> =
        races.values().flat_map(|times| times.keys()).map(|at| at.0).collect();
    let Some(&most) = sizes.last() else { bail!("book/data has no race of {discs} discs") };
    let mut numbers = String::from("\n| lab | variant |");
    for n in &sizes {
        numbers += &format!(" n = {n} |");
    }
    numbers += &format!(" two workers |\n|---|---|{}\n", "---:|".repeat(sizes.len() + 1));
    let mut text = String::from(
        "\n| variant | error | more workers | memory | when to use it |\n|---|---|---|---|---|\n",
    );
    for (lab, VariantFacts { name, error, scaling, memory, when, .. }) in words(kit)? {
        let of = (lab, name.clone());
        let none = || apart.contains_key(&of).then(Least::new);
        let Some(times) = races.get(&of).cloned().or_else(none) else { continue };
        let time = |n, workers| times.get(&(n, workers)).copied();
        numbers += &format!("| [{lab}](lab{lab}.md) | `{name}` |");
        for &n in &sizes {
            numbers += &format!(" {} |", time(n, 1).map_or("–".into(), three_digits));
        }
        let gain = time(most, 1).zip(time(most, 2)).map(|(one, two)| one / two);
        let gain = gain.map_or("–".into(), |gain| format!("{gain:.2}"));
        numbers += &format!(" {gain} |\n");
        text += &format!("| `{name}` | {error} | {scaling} | {memory} | {when} |\n");
    }
    Ok(numbers + &text)
}

/// Variants of a solution that have no row or no time, and rows whose variant no solution has.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let mut there = BTreeSet::new();
    for lab in kit.solutions() {
        for file in sources(kit, lab)? {
            let source = read_text(&file)?;
            there.extend(declared(&source).map(|name| (lab, name.to_owned())));
        }
    }
    let rows: BTreeSet<_> = words(kit)?.into_iter().map(|(lab, row)| (lab, row.name)).collect();
    let mut timed = BTreeSet::new();
    for discs in ["soft", "hard"] {
        timed.extend(races(kit, RACES, discs)?.into_keys());
        timed.extend(races(kit, APART, discs)?.into_keys());
    }
    let fault = |what: &str, (lab, name): &(Lab, String)| format!("lab {lab}, {name}: {what}");
    let odd = rows.difference(&there).map(|v| fault("no solution has this variant", v));
    let missing = there.difference(&rows).map(|v| fault("lab.toml has no row", v));
    let untimed = there.difference(&timed).map(|v| fault("no race in book/data", v));
    Ok(odd.chain(missing).chain(untimed).collect())
}

/// The sources of a solution, and of the engines that it depends on.
fn sources(kit: &Kit, lab: Lab) -> Result<Vec<PathBuf>> {
    let folder = kit.solution(lab);
    let mut sources = files_below(&folder.join("src"))?;
    for engine in kit.dependencies(&folder)?.iter().filter(|path| path.starts_with("labs/engines/"))
    {
        sources.extend(files_below(&kit.path(engine).join("src"))?);
    }
    sources.retain(|file| file.extension().is_some_and(|e| e == "rs"));
    Ok(sources)
}

/// The names of variants in a source: the first string of each `Variant { name: "…"` and of each call of a function
/// that makes one: `bitwise`, `deterministic`, or a lab's own `variant`.
fn declared(source: &str) -> impl Iterator<Item = &str> {
    let begins = ["Variant {", "variant(", "bitwise(", "deterministic("];
    let items = begins.into_iter().flat_map(|begin| source.split(begin).skip(1));
    items.filter_map(|item| {
        let item = item.trim_start();
        item.strip_prefix("name: ").unwrap_or(item).strip_prefix('"')?.split('"').next()
    })
}

#[cfg(test)]
mod tests {
    use super::{check, declared, table};
    use lab_kit::Kit;

    const SORTED: &str = "title = 'x'\ndiscs = 'soft'\nworkers = 'threads'\n[[variant]]\nname = 'sorted'\nerror = 'none'\nscaling = 'no'\nmemory = 'n'\nwhen = 'now'\n";

    /// A kit whose lab 2 declares `variants`, with these rows and one race of `sorted`.
    fn with(variants: &str, rows: &str, test: impl FnOnce(&Kit)) {
        let folder = tempfile::tempdir().unwrap();
        let run = |workers, min| {
            format!(
                r#"{{"program": "solution2:sorted,t={workers}", "scene": {{"soft": {{"n": 1000}}}},
                "ranks": null, "threads": {workers}, "nanoseconds_per_particle_and_step": {{"min": {min}}}}}"#
            )
        };
        let race =
            format!(r#"{{"results": {{"programs": [{}, {}]}}}}"#, run(1, 29.01), run(2, 20.0));
        let files = [
            ("Cargo.toml", ""),
            ("solutions/lab2/Cargo.toml", ""),
            ("solutions/lab2/src/lib.rs", variants),
            ("solutions/lab2/lab.toml", rows),
            ("book/data/compare-soft.json", &race),
            ("book/data/lab2-race.json", "not looked at"),
        ];
        test(&Kit::of_files(folder.path(), &files));
    }

    #[test]
    fn words_and_times_meet_in_one_row() {
        with("VARIANTS: &[V] = &[Variant {\n    name: \"sorted\",\n}];", SORTED, |kit| {
            let table = table(kit, "soft").unwrap();
            assert!(table.contains("| [2](lab2.md) | `sorted` | 29.0 | 1.45 |\n"), "{table}");
            assert!(table.contains("| `sorted` | none | no | n | now |\n"), "{table}");
            assert_eq!(check(kit).unwrap(), [""; 0]);
        });
    }

    #[test]
    fn a_variant_needs_a_row_and_a_time_and_a_row_a_variant() {
        with("VARIANTS: &[V] = &[\n    variant(\n        \"other\"),\n];", SORTED, |kit| {
            let faults = check(kit).unwrap();
            assert_eq!(faults.len(), 3, "{faults:?}");
            assert!(faults[0].contains("sorted: no solution"), "{faults:?}");
            assert!(faults[1].contains("other: lab.toml"), "{faults:?}");
            assert!(faults[2].contains("other: no race"), "{faults:?}");
        });
    }

    #[test]
    fn names_of_variants() {
        let source = "&[\n    Variant {\n        name: \"a\",\n        about: \"of a\",\n    },\n    \
                      variant(\n        \"b\",\n        f(\"of b\")),\n];\nconst P: P = p(\"c\");\n\
                      fn variant(name: &str) -> V {\n    Variant { name, about: \"\" }\n}";
        assert_eq!(declared(source).collect::<Vec<_>>(), ["a", "b"]);
    }
}
