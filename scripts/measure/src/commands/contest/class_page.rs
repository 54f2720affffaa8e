//! `cargo lab contest --class`: the page of a class, from files that `--json` wrote.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use lab_kit::escape::{cell, html};
use lab_kit::facts::Goal;
use lab_kit::files::{digest, write_file};
use lab_kit::{Kit, Lab};
use serde::Deserialize;

use super::entry::Entry;
use super::ranking::Ranking;
use super::{Results, landmarks, show};
use crate::chart::{Form, svg};
use crate::numbers::DataFile;

/// Folder of the three files: the page, the plane, and the points with the students' names.
const FOLDER: &str = "contest";
/// Name of the page.
const PAGE: &str = "index.html";

/// A student's best entry.
struct Student {
    name: String,
    entry: Entry,
    points: f64,
}

/// Publishes the entries in the files `NAME.json` in `folder`.
pub(super) fn write(kit: &Kit, folder: &Path) -> Result<()> {
    let into = kit.memory().join(FOLDER);
    println!("{}", publish(kit, read(folder)?, &into)?.display());
    Ok(())
}

/// Writes the page of a class, the plane and the points into the folder `into`, and returns the path
/// of the page. Every student has a name and at least one entry.
///
/// The page names nobody: each entry has a number. `points.csv` lists names, numbers and points.
///
/// # Errors
/// If there is no entry, a file cannot be written, or a goal of the lab is not a landmark.
pub fn publish(kit: &Kit, mut entries: Vec<(String, Vec<Entry>)>, into: &Path) -> Result<PathBuf> {
    // The measured times determine the digests, and only the instructor knows these times. So the
    // order of the numbers reveals no name.
    entries.sort_by_cached_key(|(_, entries)| digest(format!("{entries:?}").as_bytes()));
    let lab =
        entries.iter().flat_map(|(_, entries)| entries).next().context("no entry")?.program.lab;
    let goals = kit.facts(lab)?.goals;
    let landmarks = landmarks(kit, &[]);
    let mut students = Vec::new();
    for (name, entries) in entries {
        students.extend(best(name, entries, &goals, &landmarks)?);
    }
    let mut list = csv::Writer::from_writer(Vec::new());
    list.write_record(["name", "entry", "points"])?;
    let mut points = String::new();
    for (number, student) in (1..).zip(&mut students) {
        let Student { name, entry, points: earned } = student;
        entry.alias = Some(format!("no. {number}"));
        list.write_record([cell(name), number.to_string(), earned.to_string()])?;
        writeln!(points, "no. {number:<4} {earned:>4}")?;
    }
    let entries: Vec<Entry> = students.into_iter().map(|student| student.entry).collect();
    let tables = show::tables(&entries, &landmarks);
    let text = format!("{tables}\n\n{}\n{points}", rules(&goals));
    let plane = svg(&[vec![show::chart(&entries, &landmarks)]], Form::Page);
    let list = String::from_utf8(list.into_inner()?)?;
    for (name, text) in [(PAGE, page(lab, &text)), ("plane.svg", plane), ("points.csv", list)] {
        write_file(&into.join(name), text)?;
    }
    Ok(into.join(PAGE))
}

fn read(folder: &Path) -> Result<Vec<(String, Vec<Entry>)>> {
    let mut files = Vec::new();
    let mut seed = None;
    let listed =
        fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for file in listed {
        let path = file?.path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let measured = DataFile::read(&path)?.results;
        let results = Results::deserialize(measured);
        let results = results.with_context(|| format!("{}: no contest", path.display()))?;
        let first = *seed.get_or_insert(results.seed);
        ensure!(
            first == results.seed,
            "{} has the scenes of seed {}, and other files those of seed {first}: use one --seed",
            path.display(),
            results.seed
        );
        ensure!(!results.entries.is_empty(), "{}: no entry", path.display());
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        files.push((name, results.entries));
    }
    ensure!(!files.is_empty(), "{} has no file NAME.json", folder.display());
    Ok(files)
}

/// Returns a student's entry with the most points. If several entries have the most points, the
/// fastest of them is chosen.
fn best(
    name: String,
    entries: Vec<Entry>,
    goals: &[Goal],
    landmarks: &[Entry],
) -> Result<Option<Student>> {
    let mut best: Option<Student> = None;
    for entry in entries {
        let points = earned(&entry, goals, landmarks)?;
        let time = |entry: &Entry| entry.time.map_or(f64::INFINITY, |time| time.median);
        let is_better = best.as_ref().is_none_or(|best| {
            points > best.points || points == best.points && time(&entry) < time(&best.entry)
        });
        if is_better {
            best = Some(Student { name: name.clone(), entry, points });
        }
    }
    Ok(best)
}

/// Adds up the points for the landmarks that an entry beats in at least one ranking.
fn earned(entry: &Entry, goals: &[Goal], landmarks: &[Entry]) -> Result<f64> {
    let mut sum = 0.0;
    for Goal { beats, points } in goals {
        let landmark = landmarks.iter().find(|landmark| landmark.program.to_string() == *beats);
        let landmark = landmark.with_context(|| format!("goal: {beats} is not a landmark"))?;
        if Ranking::ALL.iter().any(|ranking| ranking.is_better(entry, landmark)) {
            sum += points;
        }
    }
    Ok(sum)
}

fn rules(goals: &[Goal]) -> String {
    let mut text =
        "points for an entry that is better than an engine in one of the rankings\n".to_owned();
    for Goal { beats, points } in goals {
        text += &format!("{points:>4}  {beats}\n");
    }
    text
}

/// Writes the page around the tables.
fn page(lab: Lab, text: &str) -> String {
    // A message about an entry may quote its program.
    let text = html(text);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>Lab {lab}: the contest</title>\n\
         <style>body {{ max-width: 60rem; margin: auto; padding: 1rem; font-family: sans-serif }} \
         img {{ max-width: 100% }} pre {{ overflow-x: auto }}</style>\n\
         <h1>Lab {lab}: the contest</h1>\n\
         <a href=\"plane.svg\"><img src=\"plane.svg\" alt=\"The entries and the kit's engines in \
         the plane of error and run time. To the left is more accurate, and down is \
         faster.\"></a>\n\
         <pre>{text}</pre>\n</html>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::super::entry::tests::entry;
    use super::*;

    #[test]
    fn points_are_for_landmarks_that_are_certainly_beaten() {
        let goal = |beats: &str, points| Goal { beats: beats.into(), points };
        let goals = [goal("solution2:sorted", 20.0), goal("solution11:planned", 80.0)];
        let sorted = entry(&[(1.0, 1.0), (1.1, 1.0)]);
        let mut planned = entry(&[(0.2, 1.0), (0.3, 1.0)]);
        planned.program = "solution11:planned".parse().unwrap();
        let mut lost = entry(&[(0.1, 1.0)]);
        lost.faults.push("crowd, seed 1: particle 3 is missing".into());
        let landmarks = [sorted, planned];
        for (entry, points) in [
            (entry(&[(0.1, 1.0)]), 100.0),
            // The rounds do not decide which of the two is faster.
            (entry(&[(0.9, 1.0), (1.0, 1.0), (1.2, 1.0)]), 0.0),
            (entry(&[(0.5, 1.0)]), 20.0),
            (entry(&[(0.9, 0.1)]), 100.0),
            (entry(&[(0.1, 2.0)]), 0.0),
            (lost, 0.0),
        ] {
            assert_eq!(earned(&entry, &goals, &landmarks).unwrap(), points, "{entry:?}");
        }
        assert!(earned(&landmarks[0], &[goal("solution1", 1.0)], &landmarks).is_err());
    }

    #[test]
    fn each_goal_of_the_kit_is_a_landmark() {
        let kit = Kit::find().unwrap();
        let landmarks = landmarks(&kit, &[]);
        for lab in kit.solutions() {
            let goals = kit.facts(lab).unwrap().goals;
            assert!(landmarks.is_empty() || earned(&landmarks[0], &goals, &landmarks).is_ok());
        }
    }
}
