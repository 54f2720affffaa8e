//! The entries of data files. Each JSON object in a file becomes an entry.
//!
//! A field of a nested object has a name such as `scene.soft.n`, and can also be found by its last
//! name, `n`. An entry also has these fields:
//!
//! - the fields of the enclosing object;
//! - `list`, the name of the list that contains the entry;
//! - the `lab`, the `variant` and the parameters of its `program`, and its `workers`;
//! - the times `ms` (milliseconds per step) and `ns` (nanoseconds per particle and step).
//!
//! In `published.toml`, each pair of numbers becomes an entry. The first number is a number of
//! workers, a number of discs, a side or a radius. The second number is a time in seconds.

use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

use anyhow::{Context, Result};
use serde_json::{Map, Number, Value, json};

use lab_kit::Kit;
use lab_kit::files::{files_below, read_text, read_toml};

/// The file with the numbers from the course's printed reports.
const PUBLISHED: &str = "published.toml";

/// An object of a data file.
pub(crate) struct Entry {
    own: BTreeMap<String, Value>,
    around: Option<Rc<Entry>>,
}

/// The data files that have been read.
pub(crate) struct Data<'k> {
    pub(crate) kit: &'k Kit,
    files: BTreeMap<String, Vec<Rc<Entry>>>,
}

impl<'k> Data<'k> {
    pub(crate) fn new(kit: &'k Kit) -> Self {
        Self { kit, files: BTreeMap::new() }
    }

    /// Returns the entries in a file of book/data, or in `published.toml`.
    ///
    /// A name such as `compare-*.json` gives the entries in all files that match.
    pub(crate) fn entries(&mut self, file: &str) -> Result<&[Rc<Entry>]> {
        if !self.files.contains_key(file) {
            let mut entries = Vec::new();
            for value in self.read(file)? {
                collect(value, "", None, &mut entries);
            }
            self.files.insert(file.into(), entries);
        }
        Ok(&self.files[file])
    }

    fn read(&self, file: &str) -> Result<Vec<Value>> {
        if file == PUBLISHED {
            return Ok(vec![read_toml(&self.kit.path("book").join(file))?]);
        }
        let folder = self.kit.path("book/data");
        let Some((begin, end)) = file.split_once('*') else {
            return Ok(vec![read_json(&folder.join(file))?]);
        };
        let mut paths = files_below(&folder)?;
        paths.retain(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(begin) && name.ends_with(end)
        });
        paths.iter().map(|path| read_json(path)).collect()
    }
}

fn read_json(path: &Path) -> Result<Value> {
    serde_json::from_str(&read_text(path)?).with_context(|| path.display().to_string())
}

/// Adds the entry or the list of entries in `value`, and all entries inside them.
fn collect(value: Value, list: &str, around: Option<&Rc<Entry>>, entries: &mut Vec<Rc<Entry>>) {
    match value {
        Value::Array(items) => match &items[..] {
            [Value::Number(x), Value::Number(seconds)] if !list.starts_with(".results") => {
                collect(published_run(list, x, seconds), list, around, entries);
            }
            _ => items.into_iter().for_each(|item| collect(item, list, around, entries)),
        },
        Value::Object(fields) => {
            let mut entry = Entry { own: BTreeMap::new(), around: around.cloned() };
            let mut lists = Vec::new();
            entry.own.insert("list".into(), list.into());
            entry.add(fields, "", &mut lists);
            entry.add_units();
            entry.add_parameters();
            let entry = Rc::new(entry);
            for (name, items) in lists {
                collect(items, &format!("{list}.{name}"), Some(&entry), entries);
            }
            entries.push(entry);
        }
        _ => {}
    }
}

/// Makes an entry from a pair in a report: a number `x` and a time in `seconds`.
///
/// The name of `x` in the entry depends on the list.
fn published_run(list: &str, x: &Number, seconds: &Number) -> Value {
    let varied = match list.rsplit('.').next() {
        Some("points") => "n",
        Some("by_side") => "side",
        Some("by_radius") => "radius",
        _ => "workers",
    };
    let is_hard = list.contains("hard") || list.contains("cs3210");
    json!({ varied: x, "seconds": { "min": seconds }, "steps": if is_hard { 50 } else { 1000 } })
}

impl Entry {
    /// Adds the object's fields to the entry. Lists in the object are added to `lists` instead,
    /// with their names.
    fn add(&mut self, fields: Map<String, Value>, prefix: &str, lists: &mut Vec<(String, Value)>) {
        for (name, value) in fields {
            let name = format!("{prefix}{name}");
            match value {
                Value::Object(fields) => self.add(fields, &format!("{name}."), lists),
                Value::Array(_) => lists.push((name, value)),
                Value::Null => {}
                _ => {
                    let last = name.rsplit('.').next().unwrap_or_default();
                    self.own.entry(last.into()).or_insert_with(|| value.clone());
                    self.own.insert(name, value);
                }
            }
        }
    }

    /// Adds the times in the units of the book, and the number of workers.
    fn add_units(&mut self) {
        for kind in ["min", "median"] {
            let seconds = self.number(&format!("seconds.{kind}"));
            if let Some((seconds, steps)) = seconds.zip(self.number("steps")) {
                self.own.insert(format!("ms.{kind}"), json!(1e3 * seconds / steps));
            }
            let ns = self.number(&format!("nanoseconds_per_particle_and_step.{kind}"));
            if let Some(ns) = ns {
                self.own.insert(format!("ns.{kind}"), json!(ns));
            }
        }
        if let Some(threads) = self.number("threads").filter(|_| self.field("workers").is_none()) {
            let ranks = self.number("ranks").unwrap_or(1.0);
            self.own.insert("workers".into(), json!(ranks * threads));
        }
    }

    /// Adds the lab, the variant and the parameters of the entry's program or engine.
    ///
    /// A program is written `solution8:master-workers,r=3,keep=0`, and an engine `LAMMPS table,
    /// skin 0.015`.
    fn add_parameters(&mut self) {
        let program = self.own.get("program").or(self.own.get("engine")).and_then(Value::as_str);
        let Some(program) = program.map(str::to_owned) else { return };
        let (package, choice) = program.split_once(':').unwrap_or(("", &program));
        let lab = package.trim_start_matches("solution").split('-').next();
        self.own.insert("lab".into(), lab.into());
        let mut words = choice.split(',');
        self.own.insert("variant".into(), words.next().into());
        for (name, value) in words.filter_map(|word| word.split_once('=')) {
            self.own.entry(name.into()).or_insert_with(|| value.into());
        }
    }

    /// Returns the field that has this full name or last name; `None` if the entry does not have
    /// it.
    pub(crate) fn field(&self, name: &str) -> Option<&Value> {
        self.own.get(name).or_else(|| self.around.as_ref()?.field(name))
    }

    /// Returns a field that is a number; `None` if there is no such field.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.field(name)?.as_f64()
    }

    /// Returns a field that is a text; `None` if there is no such field.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.field(name)?.as_str()
    }

    /// Whether a field has this value. The field `list` matches if its value ends with these parts.
    pub(crate) fn has(&self, name: &str, value: &str) -> bool {
        match self.field(name) {
            Some(Value::String(list)) if name == "list" => {
                list.strip_suffix(value).is_some_and(|rest| rest.is_empty() || rest.ends_with('.'))
            }
            Some(Value::String(text)) => text == value,
            Some(found) => found.as_f64().is_some_and(|found| value.parse() == Ok(found)),
            None => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Data;
    use lab_kit::Kit;

    const DATA: &str = r#"{"results": {"curves": [{"program": "solution9-hard:a,t=2", "strong": [
        {"scene": {"hard": {"n": 500}}, "threads": 2, "ranks": 3, "seconds": {"min": 0.5}, "steps": 10}
    ]}]}}"#;
    const PUBLISHED: &str = "[hard.threads]\nby_side = [[5000.0, 6.25]]\n";

    #[test]
    fn an_entry_has_its_own_fields_and_those_around_it() {
        let folder = tempfile::tempdir().unwrap();
        let files = [("book/data/a-1.json", DATA), ("book/published.toml", PUBLISHED)];
        let kit = Kit::of_files(folder.path(), &files);
        for (file, fields) in [
            (
                "a-*.json",
                "list=strong n=500 scene.hard.n=500 workers=6 ms.min=50 lab=9 variant=a t=2",
            ),
            ("published.toml", "list=threads.by_side side=5000 ms.min=125"),
        ] {
            let mut data = Data::new(&kit);
            let entry = &data.entries(file).unwrap()[0];
            for (name, value) in fields.split(' ').filter_map(|field| field.split_once('=')) {
                assert!(entry.has(name, value), "{name}: {:?}", entry.field(name));
            }
            assert!(!entry.has("n", "501") && entry.field("gone").is_none());
        }
    }
}
