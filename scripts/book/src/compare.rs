//! Every variant of every lab in one table: words from book/variants.toml, times from the races
//! in book/data.

use std::collections::BTreeMap;
use std::fs;

use anyhow::{Context, Result};
use serde::Deserialize;

use lab_kit::{Kit, Lab};

/// Races with this beginning of their file's name are the table's times.
const RACES: &str = "compare-";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    variant: Vec<Words>,
}

/// What no command measures.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Words {
    lab: u8,
    name: String,
    /// How its results compare with the naive program's.
    error: String,
    /// How it uses more workers.
    scaling: String,
    /// What it keeps, beside the particles.
    memory: String,
    when: String,
}

#[derive(Deserialize)]
struct Record {
    results: Race,
}

#[derive(Deserialize)]
struct Race {
    programs: Vec<Program>,
}

#[derive(Deserialize)]
struct Program {
    program: String,
    nanoseconds_per_particle_and_step: Times,
}

#[derive(Deserialize)]
struct Times {
    min: f64,
}

/// The table, lab by lab.
///
/// # Errors
/// The words or a race cannot be read.
pub(crate) fn table(kit: &Kit) -> Result<String> {
    let mut out = String::from(
        "\n| lab | variant | ns per particle and step | error | more workers | memory | when to use it |\n\
         |---|---|---|---|---|---|---|\n",
    );
    let times = times(kit)?;
    for words in words(kit)? {
        let Words { lab, name, error, scaling, memory, when } = words;
        let time =
            times.get(&format!("solution{lab}:{name}")).map_or("not timed".into(), |t| short(*t));
        out.push_str(&format!(
            "| {lab} | `{name}` | {time} | {error} | {scaling} | {memory} | {when} |\n"
        ));
    }
    Ok(out)
}

fn short(time: f64) -> String {
    if time < 100.0 { format!("{time:.1}") } else { format!("{time:.0}") }
}

fn words(kit: &Kit) -> Result<Vec<Words>> {
    let path = kit.path("book/variants.toml");
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let list: List =
        basic_toml::from_str(&text).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(list.variant)
}

/// The least times of all races for this table, by program.
fn times(kit: &Kit) -> Result<BTreeMap<String, f64>> {
    let mut times = BTreeMap::new();
    let folder = kit.path("book/data");
    for file in
        fs::read_dir(&folder).with_context(|| format!("cannot read {}", folder.display()))?
    {
        let path = file?.path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if !(name.starts_with(RACES) && name.ends_with(".json")) {
            continue;
        }
        let text = fs::read_to_string(&path)?;
        let record: Record = serde_json::from_str(&text)
            .with_context(|| format!("{} is no race", path.display()))?;
        for program in record.results.programs {
            times.insert(program.program, program.nanoseconds_per_particle_and_step.min);
        }
    }
    Ok(times)
}

/// Rows of the table whose variant no solution has.
///
/// # Errors
/// A source or the words cannot be read.
pub(crate) fn check(kit: &Kit) -> Result<Vec<String>> {
    let words = words(kit)?;
    let mut wrong = Vec::new();
    for entry in &words {
        let lab: Lab = entry.lab.to_string().parse().map_err(anyhow::Error::msg)?;
        let folder = kit.solution(lab).join("src");
        let quoted = format!("\"{}\"", entry.name);
        let known = lab_kit::files_below(&folder).is_ok_and(|files| {
            files.iter().any(|f| fs::read_to_string(f).is_ok_and(|text| text.contains(&quoted)))
        });
        if !known {
            wrong.push(format!(
                "book/variants.toml: lab {} has no variant {}",
                entry.lab, entry.name
            ));
        }
    }
    Ok(wrong)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{check, table};
    use lab_kit::Kit;

    #[test]
    fn words_and_times_meet_in_one_row() {
        let folder = tempfile::tempdir().unwrap();
        let kit = Kit::at(folder.path());
        fs::create_dir_all(kit.path("book/data")).unwrap();
        let row = |name| {
            format!(
                "[[variant]]\nlab = 2\nname = '{name}'\nerror = 'none'\nscaling = 'no'\nmemory = 'n'\nwhen = 'now'\n"
            )
        };
        fs::write(kit.path("book/variants.toml"), row("sorted") + &row("other")).unwrap();
        let race = r#"{"results": {"programs": [{"program": "solution2:sorted",
            "nanoseconds_per_particle_and_step": {"min": 29.01, "median": 30.0}}]}}"#;
        fs::write(kit.path("book/data/compare-soft.json"), race).unwrap();
        fs::write(kit.path("book/data/lab2-race.json"), "not looked at").unwrap();

        let table = table(&kit).unwrap();
        assert!(table.contains("| 2 | `sorted` | 29.0 | none | no | n | now |"), "{table}");
        assert!(table.contains("| 2 | `other` | not timed |"), "{table}");
        assert_eq!(check(&kit).unwrap().len(), 2);
    }
}
